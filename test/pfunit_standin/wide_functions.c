/* What flang 19 calls for functions of its widest kind and has no library for (x87's 64 digits are enough for the tests). */
#include <math.h>
#define ONE(name, function) \
   __float128 _FortranA##name##F128(__float128 x); \
   __float128 _FortranA##name##F128(__float128 x) { return function((long double)x); }
#define TWO(name, function) \
   __float128 _FortranA##name##F128(__float128 x, __float128 y); \
   __float128 _FortranA##name##F128(__float128 x, __float128 y) { return function((long double)x, (long double)y); }
ONE(Sqrt, sqrtl) ONE(Exp, expl) ONE(Log, logl) ONE(Log10, log10l) ONE(Sin, sinl) ONE(Cos, cosl) ONE(Tan, tanl)
ONE(Asin, asinl) ONE(Acos, acosl) ONE(Atan, atanl) ONE(Sinh, sinhl) ONE(Cosh, coshl) ONE(Tanh, tanhl)
long _FortranALroundF128(__float128 x);
long _FortranALroundF128(__float128 x) { return lroundl((long double)x); }
TWO(Atan2, atan2l) TWO(Hypot, hypotl) TWO(Pow, powl)
