/* kyvadlo: what needs GSL. C99 and C++. Double precision and SI units, thread-safe, nothing to free, as kyvadlo.h says.

   GSL's error handler, which ends a program, is neither changed nor called: a failure is a code. See doc/fitting.md and
   doc/c_interface.md. */
#ifndef KYVADLO_GSL_H
#define KYVADLO_GSL_H

#include <stddef.h>
#include <kyvadlo.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Codes besides those of kyvadlo.h. */
enum {
  KYVADLO_INPUT = 2,        /* a scene or a table that cannot be understood or breaks a rule; the message says which, and its line */
  KYVADLO_UNSUPPORTED = 4,  /* a scene that no fit takes */
  KYVADLO_NO_MINIMUM = 10   /* the search ended without a minimum */
};

/* What a fit says besides its numbers. */
typedef struct {
  size_t numbers;  /* of the free settings in the order of `free`, those of vectors one by one */
  int converged;   /* 1: a minimum */
  int dof;         /* degrees of freedom */
  double chi2;     /* sum of the squared residuals, in sigmas */
  double p_value;  /* that chance alone makes chi2 so large; NaN without a minimum */
} kyvadlo_fit_summary;

/* Fits what the &fit group of `scene` (the text of a scene file) calls free to `rows` rows of measurements. `columns` names what a row
   holds: "t x y sigma_x", as the header of a file would; `table` has row after row; NaN is an empty cell. Values, and their standard
   deviations (NaN: the data do not tell), go into `values` and `sigmas`, which have room for `room` numbers: with too little the
   code is KYVADLO_INPUT and `summary` says how many there are. Either of them, and `summary`, may be null. Returns a code; on
   failure `message` (of `capacity` bytes, always terminated; null if 0) says why, and all numbers are NaN. */
int kyvadlo_fit_rows(const char *scene, const char *columns, size_t rows, const double *table, size_t room, double *values,
   double *sigmas, kyvadlo_fit_summary *summary, char *message, size_t capacity);

/* The same of a table as text, the contents of a file of data. */
int kyvadlo_fit_text(const char *scene, const char *table, size_t room, double *values, double *sigmas,
   kyvadlo_fit_summary *summary, char *message, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
