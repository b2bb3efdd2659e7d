/* records.cc - see records.h. */
#include "base/records.h"
#include "output.h"

void records_write(const char *section, const std::string &before, const std::set<std::string> &records)
{
    if (!asm_out_file || records.empty())
        return;
    fprintf(asm_out_file, "\t.section %s,\"\",@progbits\n", section);
    for (const std::string &record : records) {
        fputs("\t.ascii ", asm_out_file);
        output_quoted_string(asm_out_file, (before + record + "\n").c_str());
        fputc('\n', asm_out_file);
    }
}
