/* error_text.h - NX's errno values as text. */
#ifndef CONTRACT_ERROR_TEXT_H
#define CONTRACT_ERROR_TEXT_H

/* What an errno value of NX stands for; NULL if it is not one of NX's. */
const char *nx_error_text(int code);

#endif
