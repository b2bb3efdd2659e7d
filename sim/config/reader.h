/* reader.h - checked reading of a libconfig file: machine files, the paper's rows, fitted factors.
 *
 * The first error is kept, with its text for the user: file:line: key: what is wrong and what is allowed.
 * Every function returns false once there is an error, so that calls chain with && and the caller reports
 * once, at its end. The line of an error is that of the setting; of a missing key, that of the group that
 * should have the key.
 */
#ifndef CONFIG_READER_H
#define CONFIG_READER_H
#include <libconfig.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct cfg_reader {
    config_t lib;
    config_setting_t *root;
    const char *path; /* as the caller gave it; must outlive the reader */
    char *error;      /* malloc'd text of the first error, NULL while all is well; the caller may take it */
};

/* Reads path and the files that it includes (@include "FILE", in the folder of path). Returns false with only
 * error set. Call cfg_close() in either case; it leaves error to the caller. */
bool cfg_open(struct cfg_reader *r, const char *path);
void cfg_close(struct cfg_reader *r);

/* Keeps "path:line: key: text" as the error unless there is one already, and returns false. at: the setting
 * in question or its group; NULL for the file as a whole. key may be NULL. */
bool cfg_fail(struct cfg_reader *r, config_setting_t *at, const char *key, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* The path of the file that has the setting: r's own (at: NULL), or one that it includes. Malloc'd. */
char *cfg_path_at(const struct cfg_reader *r, const config_setting_t *at);

/* Sets *out to the member of that name and kind. Strings belong to the reader. */
bool cfg_group(struct cfg_reader *r, config_setting_t *in, const char *key, config_setting_t **out);
bool cfg_list(struct cfg_reader *r, config_setting_t *in, const char *key, config_setting_t **out);
bool cfg_text(struct cfg_reader *r, config_setting_t *in, const char *key, const char **out);
bool cfg_whole(struct cfg_reader *r, config_setting_t *in, const char *key, uint64_t min, uint64_t max,
               uint64_t *out);
bool cfg_number(struct cfg_reader *r, config_setting_t *in, const char *key, double min, double max,
                double *out);

/* A time, 0 to one second, from KEY_us or KEY_ns, whichever is there; in picoseconds, to the nearest. tail
 * ("" or "_per_byte") ends the key: short_us_per_byte is key "short", tail "_per_byte". */
bool cfg_time(struct cfg_reader *r, config_setting_t *in, const char *key, const char *tail, uint64_t *ps);

/* The word (the list ends with NULL) most like this one; NULL: none is alike. */
const char *cfg_meant(const char *name, const char *const words[]);

/* True when every member of the group is one of keys (ended by NULL): a misspelt key is an error, not a
 * default. */
bool cfg_only(struct cfg_reader *r, config_setting_t *in, const char *const keys[]);
#endif
