/* Checks of the tests in C: what fails is printed and counted. */
#ifndef PHYSIM_TESTS_CHECK_H
#define PHYSIM_TESTS_CHECK_H

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "physim/physim.h"

extern int failures;

#define CHECK(condition) \
  ((condition) ? (void)0 \
               : (printf("%s:%d: %s [%s]\n", __FILE__, __LINE__, #condition, physim_last_error()), (void)++failures))
#define OK(call) CHECK((call) == PHYSIM_OK)
#define IS(code, call) CHECK((call) == (code))

int is_near(double a, double b, double within);
/* A def of a text that must be good. */
physim_def* made(const char* text);

/* tests/capi/c_worlds_test.c */
void test_worlds(void);
/* tests/capi/c_more_worlds_test.c */
void test_more_worlds(void);

#endif
