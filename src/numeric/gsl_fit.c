/* Nonlinear least squares by GSL's multifit_nlinear (trust region with geodesic acceleration), whose method tables are pointers
   kept in variables of libgsl, which Fortran cannot reach. Arrays in and out, nothing of GSL. */
#include <fenv.h>
#include <math.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_vector.h>

#if defined(__GNUC__)
#pragma GCC visibility push(hidden)   /* not for who links a shared kyvadlo */
#endif

/* Residuals at x, and their derivatives row by row; not 0: there are none. */
typedef int (*residuals_type)(const double *x, double *f, void *params);
typedef int (*jacobian_type)(const double *x, double *j, void *params);

int kyvadlo_gsl_least_squares(size_t n, size_t p, double *x, residuals_type residuals, jacobian_type jacobian, void *params,
   int most, double xtol, double gtol, double ftol, int *iterations, double *squares);

typedef struct {
   residuals_type residuals;
   jacobian_type jacobian;
   void *params;
} problem_type;

static int residuals_of(const gsl_vector *x, void *params, gsl_vector *f)
{
   problem_type *problem = params;
   return problem->residuals(x->data, f->data, problem->params) == 0 ? GSL_SUCCESS : GSL_EBADFUNC;
}

static int jacobian_of(const gsl_vector *x, void *params, gsl_matrix *j)
{
   problem_type *problem = params;
   return problem->jacobian(x->data, j->data, problem->params) == 0 ? GSL_SUCCESS : GSL_EBADFUNC;
}

/* The minimum next to x, which is changed, and the sum of the squares there; GSL's status. Its steps may overflow on the way, which
   is no fault: where the caller's program traps, it does not while they last. */
int kyvadlo_gsl_least_squares(size_t n, size_t p, double *x, residuals_type residuals, jacobian_type jacobian, void *params,
   int most, double xtol, double gtol, double ftol, int *iterations, double *squares)
{
   problem_type problem = {residuals, jacobian, params};
   gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
   gsl_multifit_nlinear_fdf fdf = {0};
   gsl_multifit_nlinear_workspace *room;
   gsl_vector_view start = gsl_vector_view_array(x, p);
   fenv_t callers;
   int status, info;

   how.trs = gsl_multifit_nlinear_trs_lmaccel;
   how.solver = gsl_multifit_nlinear_solver_qr;
   how.scale = gsl_multifit_nlinear_scale_more;
   fdf.f = residuals_of;
   fdf.df = jacobian_of;
   fdf.n = n;
   fdf.p = p;
   fdf.params = &problem;
   *iterations = 0;
   *squares = HUGE_VAL;
   room = gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, n, p);
   if (room == NULL) return GSL_ENOMEM;
   feholdexcept(&callers);
   status = gsl_multifit_nlinear_init(&start.vector, &fdf, room);
   /* Of derivatives that are all zero GSL would ask a solution of rank 0, which is an error for its handler; nothing else here is. */
   if (status == GSL_SUCCESS && !gsl_matrix_isnull(gsl_multifit_nlinear_jac(room))) {
      status = gsl_multifit_nlinear_driver((size_t) most, xtol, gtol, ftol, NULL, NULL, &info, room);
      *iterations = (int) gsl_multifit_nlinear_niter(room);
      gsl_vector_memcpy(&start.vector, gsl_multifit_nlinear_position(room));
   }
   gsl_blas_ddot(gsl_multifit_nlinear_residual(room), gsl_multifit_nlinear_residual(room), squares);
   fesetenv(&callers);
   gsl_multifit_nlinear_free(room);
   return status;
}
