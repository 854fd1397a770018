/* What Python cannot do itself: NumPy ufuncs over the array loops of kyvadlo.h, and the orbits' calls without the lock.
   Names, docstrings and checks of what users give are in functions.py and orbit.py. Limited API of Python 3.9. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#define NPY_TARGET_VERSION NPY_1_22_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>
#include <fenv.h>
#include <math.h>
#include <string.h>
#include <kyvadlo.h>

/* ---- Elliptic functions ---------------------------------------------------------------------------------------- */

enum { BLOCK = 512, MOST = 8 };   /* Elements to a call; real arrays in and out */

/* A function of arrays: the values of `count` <= BLOCK arguments. */
typedef void function_type(size_t count, const double *const *x, double *const *f);

#define RUN(name) static void run_##name(size_t count, const double *const *x, double *const *f)
#define ONE(name) RUN(name) { kyvadlo_##name##_many(count, x[0], f[0]); }
#define TWO(name) RUN(name) { kyvadlo_##name##_many(count, x[0], x[1], f[0]); }
#define THREE(name) RUN(name) { kyvadlo_##name##_many(count, x[0], x[1], x[2], f[0]); }
#define FOUR(name) RUN(name) { kyvadlo_##name##_many(count, x[0], x[1], x[2], x[3], f[0]); }

ONE(elliptic_k) ONE(elliptic_kc) ONE(elliptic_e) ONE(elliptic_ec) ONE(elliptic_d) ONE(elliptic_dc) ONE(elliptic_b)
ONE(elliptic_bc) ONE(elliptic_nome) ONE(elliptic_nomec)
TWO(elliptic_pi) TWO(elliptic_pic) TWO(elliptic_fc) TWO(elliptic_eincc) TWO(elliptic_dinc)
TWO(elliptic_dincc) TWO(elliptic_binc) TWO(elliptic_bincc) TWO(jacobi_zeta) TWO(jacobi_zetac) TWO(heuman_lambda)
TWO(heuman_lambdac) TWO(bulirsch_el1)
THREE(carlson_rf) THREE(carlson_rd) THREE(carlson_rg) THREE(elliptic_piinc) THREE(elliptic_piincc) THREE(bulirsch_el3)
FOUR(bulirsch_cel) FOUR(bulirsch_el2)

RUN(sncndnc) { kyvadlo_sncndnc_many(count, x[0], x[1], f[0], f[1], f[2], f[3]); }

/* SciPy's domains and edges, where ours are wider: no value for m > 1, of sn, cn, dn, am none for m < 0; infinite amplitudes
   have infinite integrals, F(phi, -inf) is 0, and at m = 1 the double next to pi/2 counts as pi/2. */
RUN(elliptic_f)
{
   const double half_pi = 1.57079632679489661923;
   size_t i;

   kyvadlo_elliptic_f_many(count, x[0], x[1], f[0]);
   for (i = 0; i < count; i++) {
      const double phi = x[0][i], m = x[1][i];

      if (m > 1) f[0][i] = NAN;
      else if (m == 1 && fabs(phi) >= half_pi) f[0][i] = copysign(INFINITY, phi);
      else if (isinf(phi) && m > -INFINITY) f[0][i] = phi;
      else if (isinf(m) && !isnan(phi) && !isinf(phi)) f[0][i] = 0;
   }
}

RUN(elliptic_einc)
{
   size_t i;

   kyvadlo_elliptic_einc_many(count, x[0], x[1], f[0]);
   for (i = 0; i < count; i++) {
      const double phi = x[0][i], m = x[1][i];

      if (m > 1) f[0][i] = NAN;
      else if (isinf(phi) && !isnan(m)) f[0][i] = phi;
      else if (isinf(m) && !isnan(phi)) f[0][i] = phi == 0 ? phi : copysign(INFINITY, phi);
   }
}

RUN(sncndn)
{
   size_t i;

   kyvadlo_sncndn_many(count, x[0], x[1], f[0], f[1], f[2], f[3]);
   for (i = 0; i < count; i++) if (!(x[1][i] >= 0 && x[1][i] <= 1)) f[0][i] = f[1][i] = f[2][i] = f[3][i] = NAN;
}

/* R_C at y = 0 and R_J at p = 0 are infinite; SciPy says NaN. */
RUN(carlson_rc)
{
   size_t i;

   kyvadlo_carlson_rc_many(count, x[0], x[1], f[0]);
   for (i = 0; i < count; i++) if (x[1][i] == 0) f[0][i] = NAN;
}

RUN(carlson_rj)
{
   size_t i;

   kyvadlo_carlson_rj_many(count, x[0], x[1], x[2], x[3], f[0]);
   for (i = 0; i < count; i++) if (x[3][i] == 0) f[0][i] = NAN;
}

/* Whole numbers come as doubles. */
static void whole(size_t count, const double *from, int *to)
{
   size_t i;

   for (i = 0; i < count; i++) to[i] = from[i] >= 1 && from[i] <= 4 ? (int)from[i] : 0;
}

#define THETA(name, call) RUN(name) { int i[BLOCK]; whole(count, x[0], i); call; }
THETA(theta, kyvadlo_theta_many(count, i, x[1], x[2], f[0]))
THETA(theta_derivative, kyvadlo_theta_derivative_many(count, i, x[1], x[2], f[0]))
THETA(complex_theta, kyvadlo_complex_theta_many(count, i, x[1], x[2], x[3], f[0], f[1]))
THETA(complex_theta_derivative, kyvadlo_complex_theta_derivative_many(count, i, x[1], x[2], x[3], f[0], f[1]))

RUN(cubic_roots)
{
   double roots[3 * BLOCK];
   int found[BLOCK];
   size_t i;

   kyvadlo_cubic_roots_many(count, x[0], x[1], x[2], x[3], roots, found);
   for (i = 0; i < count; i++) {
      f[0][i] = roots[3 * i];
      f[1][i] = roots[3 * i + 1];
      f[2][i] = roots[3 * i + 2];
      f[3][i] = found[i];
   }
}

/* A loop of a ufunc: types of NumPy, a letter for each argument and result: d f double and float, D F complex, l long. */
typedef struct {
   const char *name;
   function_type *run;
   const char *in, *out;
} loop_type;

/* The loops of one ufunc stand together; NumPy takes the first to which its arguments can be cast safely. */
#define BOTH(name, in, out, in_single, out_single) \
   {#name, run_##name, in_single, out_single}, {#name, run_##name, in, out}
#define OF_ONE(name) BOTH(name, "d", "d", "f", "f")
#define OF_TWO(name) BOTH(name, "dd", "d", "ff", "f")
#define OF_THREE(name) BOTH(name, "ddd", "d", "fff", "f")
#define OF_FOUR(name) BOTH(name, "dddd", "d", "ffff", "f")
static const loop_type loops[] = {
   OF_ONE(elliptic_k), OF_ONE(elliptic_kc), OF_ONE(elliptic_e), OF_ONE(elliptic_ec), OF_ONE(elliptic_d),
   OF_ONE(elliptic_dc), OF_ONE(elliptic_b), OF_ONE(elliptic_bc), OF_ONE(elliptic_nome), OF_ONE(elliptic_nomec),
   OF_TWO(carlson_rc), OF_TWO(elliptic_pi), OF_TWO(elliptic_pic), OF_TWO(elliptic_f), OF_TWO(elliptic_fc),
   OF_TWO(elliptic_einc), OF_TWO(elliptic_eincc), OF_TWO(elliptic_dinc), OF_TWO(elliptic_dincc), OF_TWO(elliptic_binc),
   OF_TWO(elliptic_bincc), OF_TWO(jacobi_zeta), OF_TWO(jacobi_zetac), OF_TWO(heuman_lambda), OF_TWO(heuman_lambdac),
   OF_TWO(bulirsch_el1), OF_THREE(carlson_rf), OF_THREE(carlson_rd), OF_THREE(carlson_rg), OF_THREE(elliptic_piinc),
   OF_THREE(elliptic_piincc), OF_THREE(bulirsch_el3), OF_FOUR(carlson_rj), OF_FOUR(bulirsch_cel), OF_FOUR(bulirsch_el2),
   BOTH(sncndn, "dd", "dddd", "ff", "ffff"), BOTH(sncndnc, "dd", "dddd", "ff", "ffff"),
   BOTH(theta, "ldd", "d", "lff", "f"),
   {"theta", run_complex_theta, "lFf", "F"}, {"theta", run_complex_theta, "lDd", "D"},
   BOTH(theta_derivative, "ldd", "d", "lff", "f"),
   {"theta_derivative", run_complex_theta_derivative, "lFf", "F"},
   {"theta_derivative", run_complex_theta_derivative, "lDd", "D"},
   BOTH(cubic_roots, "dddd", "dddl", "ffff", "fffl")
};
enum { LOOPS = sizeof loops / sizeof *loops, MOST_ALIKE = 4 };

/* Copies elements `step` bytes apart into real arrays, two for a complex type; how many arrays. */
static int gather(char type, size_t count, const char *from, npy_intp step, double (*to)[BLOCK])
{
   size_t i;

   switch (type) {
   case 'd': for (i = 0; i < count; i++, from += step) to[0][i] = *(const double *)from; return 1;
   case 'f': for (i = 0; i < count; i++, from += step) to[0][i] = *(const float *)from; return 1;
   case 'l': for (i = 0; i < count; i++, from += step) to[0][i] = (double)*(const long *)from; return 1;
   case 'D': for (i = 0; i < count; i++, from += step) {
         to[0][i] = ((const double *)from)[0];
         to[1][i] = ((const double *)from)[1];
      }
      return 2;
   default: for (i = 0; i < count; i++, from += step) {
         to[0][i] = ((const float *)from)[0];
         to[1][i] = ((const float *)from)[1];
      }
      return 2;
   }
}

static int scatter(char type, size_t count, double *const *from, char *to, npy_intp step)
{
   size_t i;

   switch (type) {
   case 'd': for (i = 0; i < count; i++, to += step) *(double *)to = from[0][i]; return 1;
   case 'f': for (i = 0; i < count; i++, to += step) *(float *)to = (float)from[0][i]; return 1;
   case 'l': for (i = 0; i < count; i++, to += step) *(long *)to = (long)from[0][i]; return 1;
   case 'D': for (i = 0; i < count; i++, to += step) {
         ((double *)to)[0] = from[0][i];
         ((double *)to)[1] = from[1][i];
      }
      return 2;
   default: for (i = 0; i < count; i++, to += step) {
         ((float *)to)[0] = (float)from[0][i];
         ((float *)to)[1] = (float)from[1][i];
      }
      return 2;
   }
}

/* The inner loop of all ufuncs. Arrays of doubles without gaps are handed on as they are, unless a result shares their memory:
   Fortran would not expect that. The flags of floating-point arithmetic stay as they were: NaN and infinities are
   answers here, not warnings. */
static void inner_loop(char **args, npy_intp const *dimensions, npy_intp const *steps, void *data)
{
   const loop_type *loop = data;
   const int inputs = (int)strlen(loop->in), outputs = (int)strlen(loop->out);
   double room[MOST][BLOCK];
   const size_t total = (size_t)dimensions[0];
   fenv_t environment;
   size_t start, count;

   feholdexcept(&environment);
   for (start = 0; start < total; start += BLOCK) {
      const double *x[MOST] = {0};
      double *f[MOST] = {0};
      char *at[MOST];
      int is_direct[MOST], j, k, used = 0, number = 0;

      count = total - start < BLOCK ? total - start : BLOCK;
      for (j = 0; j < inputs + outputs; j++) at[j] = args[j] + (npy_intp)start * steps[j];
      for (j = 0; j < outputs; j++) {
         is_direct[j] = loop->out[j] == 'd' && steps[inputs + j] == sizeof(double);
         f[number++] = is_direct[j] ? (double *)at[inputs + j] : room[used++];
         if (loop->out[j] == 'D' || loop->out[j] == 'F') f[number++] = room[used++];
      }
      for (j = 0, number = 0; j < inputs; j++) {
         int is_whole = loop->in[j] == 'd' && steps[j] == sizeof(double);

         for (k = 0; k < outputs; k++)
            if (is_direct[k] && at[inputs + k] < at[j] + count * sizeof(double)
                && at[j] < at[inputs + k] + count * sizeof(double)) is_whole = 0;
         if (is_whole) {
            x[number++] = (const double *)at[j];
         } else {
            int arrays = gather(loop->in[j], count, at[j], steps[j], room + used);

            for (k = 0; k < arrays; k++) x[number++] = room[used++];
         }
      }
      loop->run(count, x, f);
      for (j = 0, number = 0; j < outputs; j++)
         number += is_direct[j] ? 1 : scatter(loop->out[j], count, f + number, at[inputs + j], steps[inputs + j]);
   }
   fesetenv(&environment);
}

static char *copy_text(const char *text)
{
   char *copy = PyMem_Malloc(strlen(text) + 1);

   return copy == NULL ? NULL : strcpy(copy, text);
}

/* ufunc(function, name, doc): a ufunc. What it points to lives as long as Python does. */
static PyObject *new_ufunc(PyObject *module, PyObject *args)
{
   static PyUFuncGenericFunction same[MOST_ALIKE] = {inner_loop, inner_loop, inner_loop, inner_loop};
   const char *function, *name, *doc;
   const loop_type *first;
   int count = 0, inputs, outputs, i, j;
   void **data;
   char *types, *next;

   (void)module;
   if (!PyArg_ParseTuple(args, "sss", &function, &name, &doc)) return NULL;
   for (first = loops; first < loops + LOOPS && strcmp(first->name, function) != 0; first++) ;
   while (first + count < loops + LOOPS && strcmp(first[count].name, function) == 0) count++;
   if (count == 0) return PyErr_Format(PyExc_LookupError, "no function %s", function);
   inputs = (int)strlen(first->in);
   outputs = (int)strlen(first->out);
   data = PyMem_Malloc(count * sizeof *data);
   types = next = PyMem_Malloc(count * (inputs + outputs));
   name = copy_text(name);
   doc = copy_text(doc);
   if (data == NULL || types == NULL || name == NULL || doc == NULL) return PyErr_NoMemory();
   for (i = 0; i < count; i++) {
      data[i] = (void *)&first[i];
      for (j = 0; j < inputs + outputs; j++) {
         switch (j < inputs ? first[i].in[j] : first[i].out[j - inputs]) {
         case 'd': *next++ = NPY_DOUBLE; break;
         case 'f': *next++ = NPY_FLOAT; break;
         case 'l': *next++ = NPY_LONG; break;
         case 'D': *next++ = NPY_CDOUBLE; break;
         default: *next++ = NPY_CFLOAT;
         }
      }
   }
   return PyUFunc_FromFuncAndData(same, data, types, count, inputs, outputs, PyUFunc_None, name, doc, 0);
}

/* ---- Orbits ------------------------------------------------------------------------------------------------------ */

/* None. Py_RETURN_NONE of Python 3.12's header counts no reference, as if every Python's None were immortal. */
static PyObject *none(void)
{
   Py_IncRef(Py_None);
   return Py_None;
}

typedef int from_two_numbers(double, double, double, double, kyvadlo_orbit *, char *, size_t);
static const struct {
   const char *name;
   from_two_numbers *set_up;
} makers[] = {
   {"heights", kyvadlo_orbit_from_heights}, {"gaps", kyvadlo_orbit_from_gaps}, {"rises", kyvadlo_orbit_from_rises},
   {"energy", kyvadlo_orbit_from_energy}, {"energy_above_top", kyvadlo_orbit_from_energy_above_top},
   {"energy_above_bottom", kyvadlo_orbit_from_energy_above_bottom}, {"release", kyvadlo_orbit_from_release}
};
enum { MAKERS = sizeof makers / sizeof *makers, LENGTH_OF_MESSAGE = 1000 };

/* The number of the maker, MAKERS for a state, which has three numbers in the place of each of the two. -1: none. */
static int read_start(PyObject *args, const char **name, double *length, double *gravity, double *a, double *b,
   PyObject **rest, PyObject **more)
{
   PyObject *first, *second;
   int i;

   *rest = *more = NULL;
   if (!PyArg_ParseTuple(args, "sddOO|OO", name, length, gravity, &first, &second, rest, more)) return -1;
   if (strcmp(*name, "state") == 0)
      return PyArg_ParseTuple(first, "ddd", a, a + 1, a + 2) && PyArg_ParseTuple(second, "ddd", b, b + 1, b + 2) ? MAKERS : -1;
   *a = PyFloat_AsDouble(first);
   *b = PyFloat_AsDouble(second);
   if (PyErr_Occurred()) return -1;
   for (i = 0; i < MAKERS; i++) if (strcmp(makers[i].name, *name) == 0) return i;
   PyErr_Format(PyExc_LookupError, "no start %s", *name);
   return -1;
}

/* orbit(maker, length, gravity, a, b): the bytes of an orbit, or ValueError. */
static PyObject *new_orbit(PyObject *module, PyObject *args)
{
   kyvadlo_orbit orbit;
   char message[LENGTH_OF_MESSAGE];
   const char *name;
   PyObject *rest, *more;
   double length, gravity, a[3], b[3];
   int maker, code;

   (void)module;
   maker = read_start(args, &name, &length, &gravity, a, b, &rest, &more);
   if (maker < 0) return NULL;
   if (maker == MAKERS)
      code = kyvadlo_orbit_from_state(length, gravity, a, b, &orbit, message, sizeof message);
   else
      code = makers[maker].set_up(length, gravity, *a, *b, &orbit, message, sizeof message);
   if (code != KYVADLO_OK) {
      PyErr_SetString(PyExc_ValueError, message);
      return NULL;
   }
   return PyBytes_FromStringAndSize((const char *)&orbit, sizeof orbit);
}

/* The struct in the bytes that `orbit` made; they stay where they are, and nothing writes into them. */
static const kyvadlo_orbit *orbit_of(PyObject *bytes)
{
   if (!PyBytes_Check(bytes) || PyBytes_Size(bytes) != sizeof(kyvadlo_orbit)) {
      PyErr_SetString(PyExc_TypeError, "not the bytes of an orbit");
      return NULL;
   }
   return (const kyvadlo_orbit *)PyBytes_AsString(bytes);
}

/* The elements of a contiguous array of doubles; NULL with an exception if it is something else. */
static double *doubles(PyObject *object, npy_intp expected)
{
   PyArrayObject *array = (PyArrayObject *)object;

   if (!PyArray_Check(object) || PyArray_TYPE(array) != NPY_DOUBLE || !PyArray_ISCARRAY_RO(array)
       || (expected >= 0 && PyArray_SIZE(array) != expected)) {
      PyErr_SetString(PyExc_TypeError, "not a contiguous array of doubles of the right size");
      return NULL;
   }
   return PyArray_DATA(array);
}

/* constants(orbit): what does not change along it, then the eight numbers of kyvadlo_turning. */
static PyObject *constants(PyObject *module, PyObject *bytes)
{
   static double (*const of_orbit[])(const kyvadlo_orbit *) = {kyvadlo_height_period, kyvadlo_modulus,
      kyvadlo_complementary_modulus, kyvadlo_quarter_period, kyvadlo_nome, kyvadlo_azimuth_rate, kyvadlo_azimuth_per_period,
      kyvadlo_apsidal_advance, kyvadlo_apsidal_angle, kyvadlo_orbit_energy, kyvadlo_orbit_momentum};
   enum { COUNT = sizeof of_orbit / sizeof *of_orbit };
   const kyvadlo_orbit *orbit = orbit_of(bytes);
   double values[COUNT + 8];
   PyObject *tuple;
   int i;

   (void)module;
   if (orbit == NULL) return NULL;
   for (i = 0; i < COUNT; i++) values[i] = of_orbit[i](orbit);
   kyvadlo_turning(orbit, values + COUNT);
   tuple = PyTuple_New(COUNT + 8);
   for (i = 0; tuple != NULL && i < COUNT + 8; i++) {
      PyObject *number = PyFloat_FromDouble(values[i]);

      if (number == NULL || PyTuple_SetItem(tuple, i, number) != 0) Py_CLEAR(tuple);
   }
   return tuple;
}

/* locate(orbit, times, positions, velocities, threads): fills the arrays. */
static PyObject *locate(PyObject *module, PyObject *args)
{
   PyObject *bytes, *times, *positions, *velocities;
   const kyvadlo_orbit *orbit;
   double *t, *x, *v;
   npy_intp count;
   int threads;

   (void)module;
   if (!PyArg_ParseTuple(args, "OOOOi", &bytes, &times, &positions, &velocities, &threads)
       || (orbit = orbit_of(bytes)) == NULL || (t = doubles(times, -1)) == NULL) return NULL;
   count = PyArray_SIZE((PyArrayObject *)times);
   if ((x = doubles(positions, 3 * count)) == NULL || (v = doubles(velocities, 3 * count)) == NULL) return NULL;
   Py_BEGIN_ALLOW_THREADS
   kyvadlo_locate_many_threads(orbit, (size_t)count, t, x, v, threads);
   Py_END_ALLOW_THREADS
   return none();
}

/* periods_from_gaps(length, gravity, upper_gaps, lower_rises, periods, advances, threads): fills the two arrays. */
static PyObject *periods_from_gaps(PyObject *module, PyObject *args)
{
   PyObject *gaps, *rises, *periods, *advances;
   double length, gravity, *a, *b, *t, *turn;
   npy_intp count;
   int threads;

   (void)module;
   if (!PyArg_ParseTuple(args, "ddOOOOi", &length, &gravity, &gaps, &rises, &periods, &advances, &threads)
       || (a = doubles(gaps, -1)) == NULL) return NULL;
   count = PyArray_SIZE((PyArrayObject *)gaps);
   if ((b = doubles(rises, count)) == NULL || (t = doubles(periods, count)) == NULL
       || (turn = doubles(advances, count)) == NULL) return NULL;
   Py_BEGIN_ALLOW_THREADS
   kyvadlo_orbits_period_from_gaps(length, gravity, (size_t)count, a, b, t, threads);
   kyvadlo_orbits_advance_from_gaps(length, (size_t)count, a, b, turn, threads);
   Py_END_ALLOW_THREADS
   return none();
}

/* constants_from_gaps(length, gravity, upper_gaps, lower_rises, constants, threads): fills the array. */
static PyObject *constants_from_gaps(PyObject *module, PyObject *args)
{
   PyObject *gaps, *rises, *constants;
   double length, gravity, *a, *b, *c;
   npy_intp count;
   int threads;

   (void)module;
   if (!PyArg_ParseTuple(args, "ddOOOi", &length, &gravity, &gaps, &rises, &constants, &threads)
       || (a = doubles(gaps, -1)) == NULL) return NULL;
   count = PyArray_SIZE((PyArrayObject *)gaps);
   if ((b = doubles(rises, count)) == NULL || (c = doubles(constants, 8 * count)) == NULL) return NULL;
   Py_BEGIN_ALLOW_THREADS
   kyvadlo_orbits_constants_from_gaps(length, gravity, (size_t)count, a, b, c, threads);
   Py_END_ALLOW_THREADS
   return none();
}

/* locate_from_gaps(length, gravity, upper_gaps, lower_rises, t, positions, velocities, threads): fills the two arrays. */
static PyObject *locate_from_gaps(PyObject *module, PyObject *args)
{
   PyObject *gaps, *rises, *positions, *velocities;
   double length, gravity, time, *a, *b, *x, *v;
   npy_intp count;
   int threads;

   (void)module;
   if (!PyArg_ParseTuple(args, "ddOOdOOi", &length, &gravity, &gaps, &rises, &time, &positions, &velocities, &threads)
       || (a = doubles(gaps, -1)) == NULL) return NULL;
   count = PyArray_SIZE((PyArrayObject *)gaps);
   if ((b = doubles(rises, count)) == NULL || (x = doubles(positions, 3 * count)) == NULL
       || (v = doubles(velocities, 3 * count)) == NULL) return NULL;
   Py_BEGIN_ALLOW_THREADS
   kyvadlo_orbits_locate_from_gaps(length, gravity, (size_t)count, a, b, time, x, v, threads);
   Py_END_ALLOW_THREADS
   return none();
}

/* evaluate(orbit, what, arguments, values): fills `values`, one by one but for azimuths. */
static PyObject *evaluate(PyObject *module, PyObject *args)
{
   static const struct {
      const char *name;
      double (*at)(const kyvadlo_orbit *, double);
   } functions[] = {
      {"height", kyvadlo_height}, {"rise", kyvadlo_rise}, {"gap", kyvadlo_top_clearance}, {"azimuth", kyvadlo_azimuth},
      {"vertical_speed", kyvadlo_vertical_speed}, {"azimuthal_speed", kyvadlo_azimuthal_speed}, {"speed", kyvadlo_speed},
      {"rod_force", kyvadlo_rod_force}, {"time_to_height", kyvadlo_time_to_height}, {"time_to_rise", kyvadlo_time_to_rise},
      {"time_to_azimuth", kyvadlo_time_to_azimuth}, {"next_turning_time", kyvadlo_next_turning_time}
   };
   enum { COUNT = sizeof functions / sizeof *functions };
   PyObject *bytes, *arguments, *values;
   const kyvadlo_orbit *orbit;
   const char *what;
   double *x, *y;
   npy_intp count, i;
   int which = 0;

   (void)module;
   if (!PyArg_ParseTuple(args, "OsOO", &bytes, &what, &arguments, &values) || (orbit = orbit_of(bytes)) == NULL
       || (x = doubles(arguments, -1)) == NULL) return NULL;
   count = PyArray_SIZE((PyArrayObject *)arguments);
   if ((y = doubles(values, count)) == NULL) return NULL;
   while (which < COUNT && strcmp(functions[which].name, what) != 0) which++;
   if (which == COUNT) return PyErr_Format(PyExc_LookupError, "no function %s", what);
   Py_BEGIN_ALLOW_THREADS
   if (functions[which].at == kyvadlo_azimuth) kyvadlo_azimuths(orbit, (size_t)count, x, y, 1);
   else for (i = 0; i < count; i++) y[i] = functions[which].at(orbit, x[i]);
   Py_END_ALLOW_THREADS
   return none();
}

/* derivatives(maker, length, gravity, a, b, times, (states, matrices, periods)): fills the three arrays. */
static PyObject *derivatives(PyObject *module, PyObject *args)
{
   /* In the order of `makers`; none from an energy above a pole. */
   static int (*const from_numbers[MAKERS])(double, double, double, double, size_t, const double *, double *, double *, double *,
      char *, size_t) = {kyvadlo_derivatives_from_heights, kyvadlo_derivatives_from_gaps, kyvadlo_derivatives_from_rises,
      kyvadlo_derivatives_from_energy, NULL, NULL, kyvadlo_derivatives_from_release};
   char message[LENGTH_OF_MESSAGE];
   const char *name;
   PyObject *times, *more, *states, *matrices, *periods;
   double length, gravity, a[3], b[3], *t, *s, *m, *p;
   npy_intp count, columns;
   int maker, code;

   (void)module;
   maker = read_start(args, &name, &length, &gravity, a, b, &times, &more);
   if (maker < 0) return NULL;
   if (times == NULL || more == NULL || (maker < MAKERS && from_numbers[maker] == NULL)) {
      PyErr_SetString(PyExc_TypeError, "derivatives(maker, length, gravity, a, b, times, arrays)");
      return NULL;
   }
   columns = maker == MAKERS ? 9 : 5;
   if (!PyArg_ParseTuple(more, "OOO", &states, &matrices, &periods) || (t = doubles(times, -1)) == NULL) return NULL;
   count = PyArray_SIZE((PyArrayObject *)times);
   if ((s = doubles(states, 6 * count)) == NULL || (m = doubles(matrices, 6 * columns * count)) == NULL
       || (p = doubles(periods, 2 * (columns - 1))) == NULL) return NULL;
   Py_BEGIN_ALLOW_THREADS
   if (maker == MAKERS)
      code = kyvadlo_derivatives_from_state(length, gravity, a, b, (size_t)count, t, s, m, p, message, sizeof message);
   else
      code = from_numbers[maker](length, gravity, *a, *b, (size_t)count, t, s, m, p, message, sizeof message);
   Py_END_ALLOW_THREADS
   if (code != KYVADLO_OK) {
      PyErr_SetString(PyExc_ValueError, message);
      return NULL;
   }
   return none();
}

static PyMethodDef methods[] = {
   {"ufunc", new_ufunc, METH_VARARGS, "ufunc(function, name, doc)"},
   {"orbit", new_orbit, METH_VARARGS, "orbit(maker, length, gravity, a, b)"},
   {"constants", constants, METH_O, "constants(orbit)"},
   {"locate", locate, METH_VARARGS, "locate(orbit, times, positions, velocities, threads)"},
   {"periods_from_gaps", periods_from_gaps, METH_VARARGS,
      "periods_from_gaps(length, gravity, upper_gaps, lower_rises, periods, advances, threads)"},
   {"constants_from_gaps", constants_from_gaps, METH_VARARGS,
      "constants_from_gaps(length, gravity, upper_gaps, lower_rises, constants, threads)"},
   {"locate_from_gaps", locate_from_gaps, METH_VARARGS,
      "locate_from_gaps(length, gravity, upper_gaps, lower_rises, t, positions, velocities, threads)"},
   {"evaluate", evaluate, METH_VARARGS, "evaluate(orbit, what, arguments, values)"},
   {"derivatives", derivatives, METH_VARARGS, "derivatives(maker, length, gravity, a, b, times, arrays)"},
   {NULL, NULL, 0, NULL}
};

static int execute(PyObject *module)
{
   (void)module;
   return PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0 ? -1 : 0;
}

static PyModuleDef_Slot slots[] = {{Py_mod_exec, (void *)execute}, {0, NULL}};
static struct PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_kyvadlo", NULL, 0, methods, slots, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__kyvadlo(void)
{
   return PyModuleDef_Init(&definition);
}
