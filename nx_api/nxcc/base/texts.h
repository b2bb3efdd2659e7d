/* texts.h - the texts of a compiled file's table, each written once to the assembly. */
#ifndef NXCC_TEXTS_H
#define NXCC_TEXTS_H
#include <map>
#include <string>
#include <vector>

class texts
{
  public:
    /* The text with number i gets the label .LNAMEi. */
    explicit texts(const char *name) : label(name) {}
    /* The number of a text. */
    int number(const std::string &s);
    /* Writes all of them. */
    void write() const;

  private:
    std::string label;
    std::vector<std::string> all;
    std::map<std::string, int> numbers;
};
#endif
