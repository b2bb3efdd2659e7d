/* texts.cc - see texts.h. */
#include "base/gcc.h"
#include "base/texts.h"
#include "output.h"

int texts::number(const std::string &s)
{
    auto found = numbers.find(s);
    if (found != numbers.end())
        return found->second;
    all.push_back(s);
    return numbers[s] = (int)all.size() - 1;
}

void texts::write() const
{
    for (size_t i = 0; i < all.size(); i++) {
        fprintf(asm_out_file, ".L%s%zu:\t.string ", label.c_str(), i);
        output_quoted_string(asm_out_file, all[i].c_str());
        fputc('\n', asm_out_file);
    }
}
