// Boost.Math for `kyvadlo-bench --functions`; compiled only where Boost's headers were found. The ids are those of
// bench_rows.f90; `x` and `out` are columns of `n` numbers, with the modulus in the place of the parameter.
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/heuman_lambda.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/special_functions/jacobi_zeta.hpp>

namespace {

using namespace boost::math;
enum id { rc = 1, rf, rd, rj, rg, k, kc, e, d, b, nome, pi, f, einc, dinc, piinc, zeta, lambda, jacobi, jacobi_am,
          jacobic, set_up };

template <class Function>
int fill(int n, double *out, Function function)
{
   for (int i = 0; i < n; ++i) out[i] = function(i);
   return 1;
}

template <class Policy>
int values(int id, int n, const double *x, double *out, const Policy &policy)
{
   const double *y = x + n, *z = y + n, *p = z + n;
   switch (id) {
   case rc: return fill(n, out, [=](int i) { return ellint_rc(x[i], y[i], policy); });
   case rf: return fill(n, out, [=](int i) { return ellint_rf(x[i], y[i], z[i], policy); });
   case rd: return fill(n, out, [=](int i) { return ellint_rd(x[i], y[i], z[i], policy); });
   case rj: return fill(n, out, [=](int i) { return ellint_rj(x[i], y[i], z[i], p[i], policy); });
   case rg: return fill(n, out, [=](int i) { return ellint_rg(x[i], y[i], z[i], policy); });
   case k: return fill(n, out, [=](int i) { return ellint_1(x[i], policy); });
   case e: return fill(n, out, [=](int i) { return ellint_2(x[i], policy); });
   case d: return fill(n, out, [=](int i) { return ellint_d(x[i], policy); });
   case pi: return fill(n, out, [=](int i) { return ellint_3(y[i], x[i], policy); });
   case f: return fill(n, out, [=](int i) { return ellint_1(y[i], x[i], policy); });
   case einc: return fill(n, out, [=](int i) { return ellint_2(y[i], x[i], policy); });
   case dinc: return fill(n, out, [=](int i) { return ellint_d(y[i], x[i], policy); });
   case piinc: return fill(n, out, [=](int i) { return ellint_3(z[i], x[i], y[i], policy); });
   case zeta: return fill(n, out, [=](int i) { return jacobi_zeta(y[i], x[i], policy); });
   case lambda: return fill(n, out, [=](int i) { return heuman_lambda(y[i], x[i], policy); });
   case jacobi:
   case set_up:
      return fill(n, out, [=](int i) {
         return jacobi_elliptic(y[i], x[i], &out[n + i], &out[2*n + i], policy);
      });
   }
   return 0;
}

}

extern "C" int kyvadlo_boost_values(int id, int promotes, int n, const double *x, double *out)
{
   try {
      if (promotes) return values(id, n, x, out, policies::policy<>());
      return values(id, n, x, out, policies::policy<policies::promote_double<false>>());
   } catch (...) {
      return 0;
   }
}
