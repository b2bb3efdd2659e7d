/* race_comments.cc - see race_comments.h. */
#include "base/gcc.h"
#include "checks/race_comments.h"
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace
{
std::map<std::string, std::set<int>> files; /* the lines of each file that has been read */

/* Does a line hold nothing before its comment? Comments of C begin with / or *; of Fortran with !, or in the
 * first column with a letter or *. */
bool is_comment_alone(const std::string &text, size_t mark)
{
    size_t first = text.find_first_not_of(" \t");
    if (strchr("/*!", text[first]) || (first == 0 && strchr("cCdD", text[0])))
        return first <= mark;
    return false;
}

std::set<int> read_lines(const std::string &file)
{
    std::set<int> lines;
    std::ifstream in(file);
    std::string text;
    for (int line = 1; std::getline(in, text); line++) {
        size_t mark = text.find("nxcc: race-ok");
        if (mark == std::string::npos)
            continue;
        lines.insert(line);
        if (is_comment_alone(text, mark))
            lines.insert(line + 1);
    }
    return lines;
}
} // namespace

bool race_comments_say_ok(const char *file, int line)
{
    if (!file)
        return false;
    auto found = files.find(file);
    if (found == files.end())
        found = files.insert({file, read_lines(file)}).first;
    return found->second.count(line) > 0;
}
