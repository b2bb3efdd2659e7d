/* answers.h - what a server answers to requests: see serve.h. */
#ifndef LAB_SERVE_ANSWERS_H
#define LAB_SERVE_ANSWERS_H
#include "lab/serve/server.h"

/* The request callback of evhttp; arg: the server. */
void answer(struct evhttp_request *request, void *arg);
/* Tells all pages that listen what is new. */
void answer_news(struct server *s);
#endif
