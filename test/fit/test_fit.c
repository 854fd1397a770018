/* Fits from C: the case study "Pendulum" of lsqfit 13.3.1 (published: g/l = 39.82(87), theta(0) = 1.595(32), 10 degrees of freedom),
   what is not told, and what is refused. */
#include <kyvadlo_gsl.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0, passes = 0;

static void check(int condition, const char *what)
{
  if (condition) {
    ++passes;
  } else {
    ++failures;
    printf("FAIL %s\n", what);
  }
}

static const double angles[11][4] = { /* t, sigma_t, angle, sigma_angle */
  {0.0, NAN, 1.571, 0.050}, {0.1, 0.01, 1.477, 0.079}, {0.2, 0.01, 0.791, 0.079}, {0.3, 0.01, -0.046, 0.079},
  {0.4, 0.01, -0.852, 0.079}, {0.5, 0.01, -1.523, 0.079}, {0.6, 0.01, -1.647, 0.079}, {0.7, 0.01, -1.216, 0.079},
  {0.8, 0.01, -0.810, 0.079}, {0.9, 0.01, 0.185, 0.079}, {1.0, 0.01, 0.832, 0.079}};

static const char *scene = "&pendulum length=1 /\n"
  "&fit free='gravity release_angle' prior_gravity=40 prior_sigma_gravity=20 /\n";

static int handled = 0;

static void handler(const char *reason, const char *file, int line, int code)
{
  (void) code;
  ++handled;
  printf("GSL's handler was called: %s:%d: %s\n", file, line, reason);
}

int main(void)
{
  double values[8], sigmas[8], same[8];
  char message[300], table[1000] = "t,sigma_t,angle,sigma_angle\n", *end;
  kyvadlo_fit_summary summary;
  double still[30][2];
  int i, code;

  /* No fit calls GSL's error handler, which would end a program that left it alone. */
  gsl_set_error_handler(handler);
  code = kyvadlo_fit_rows(scene, "t sigma_t angle sigma_angle", 11, angles[0], 8, values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_OK && message[0] == 0 && summary.converged == 1 && summary.numbers == 2, "the published case is fitted");
  check(fabs(values[0] - 39.82) < 0.005 && fabs(sigmas[0] - 0.87) < 0.005, "g/l is 39.82(87)");
  check(fabs(values[1]*acos(-1.0)/180 - 1.595) < 0.0005 && fabs(sigmas[1]*acos(-1.0)/180 - 0.032) < 0.0005, "theta(0) is 1.595(32)");
  check(summary.dof == 10 && fabs(summary.chi2 - 7) < 0.5 && fabs(summary.p_value - 0.73) < 0.006, "chi2/dof is 0.7 [10], Q 0.73");
  check(isnan(values[2]) && isnan(sigmas[7]), "what is not free has no number");

  end = table + strlen(table);
  for (i = 0; i < 11; i++) {
    if (i == 0)
      end += sprintf(end, "0,,%.3f,%.3f\n", angles[i][2], angles[i][3]);
    else
      end += sprintf(end, "%.1f,%.2f,%.3f,%.3f\n", angles[i][0], angles[i][1], angles[i][2], angles[i][3]);
  }
  code = kyvadlo_fit_text(scene, table, 8, same, NULL, NULL, message, sizeof message);
  check(code == KYVADLO_OK && same[0] == values[0] && same[1] == values[1], "a table as text gives the same");

  /* How many numbers there are. */
  code = kyvadlo_fit_rows(scene, "t sigma_t angle sigma_angle", 11, angles[0], 0, NULL, NULL, &summary, NULL, 0);
  check(code == KYVADLO_OK && summary.numbers == 2, "without room the numbers are counted");
  code = kyvadlo_fit_rows(scene, "t sigma_t angle sigma_angle", 11, angles[0], 1, values, NULL, &summary, message, sizeof message);
  check(code == KYVADLO_INPUT && summary.numbers == 2 && isnan(values[0]) && strstr(message, "room"), "too little room is said");

  /* Angles do not tell length from gravity: a valley is a minimum. */
  code = kyvadlo_fit_rows("&pendulum /\n&fit free='length gravity release_angle' /\n", "t sigma_t angle sigma_angle", 11, angles[0], 8,
    values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_OK && summary.converged == 1 && isnan(sigmas[0]) && isnan(sigmas[1]) && sigmas[2] > 0
    && fabs(values[1]/values[0] - 39.8) < 0.2, "of a valley the sigmas are NaN");

  code = kyvadlo_fit_rows("&pendulum /\n", "t angle", 2, angles[0], 8, values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_INPUT && strstr(message, "&fit") && isnan(values[0]) && !summary.converged, "a scene without &fit");
  code = kyvadlo_fit_rows(scene, "t angel", 2, angles[0], 8, values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_INPUT && strstr(message, "angel"), "an unknown column");
  code = kyvadlo_fit_rows(scene, "t angle t", 2, angles[0], 8, values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_INPUT && strstr(message, "twice"), "a column twice");
  code = kyvadlo_fit_rows(scene, "t angle", 1, angles[0], 8, values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_INPUT && strstr(message, "two rows"), "one row");
  code = kyvadlo_fit_rows(scene, "t angle", 0, NULL, 8, values, sigmas, &summary, message, 10);
  check(code == KYVADLO_INPUT && strlen(message) == 9, "no row, and a short message");
  code = kyvadlo_fit_text(scene, "t,angle\n0,1\n1,inf\n2,1\n", 8, values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_INPUT && strstr(message, "table:3"), "an infinite number, with its line");
  same[0] = INFINITY;
  code = kyvadlo_fit_rows(scene, "t", 1, same, 8, values, sigmas, NULL, message, sizeof message);
  check(code == KYVADLO_INPUT, "an infinite number in an array");

  /* Searches with nothing to go on: a bob at rest, whose derivatives are zero; wild numbers; in air, integrated. */
  for (i = 0; i < 30; i++) {
    still[i][0] = 0.1*i;
    still[i][1] = i%2 ? 1e-3 : -1e-3;
  }
  code = kyvadlo_fit_rows("&pendulum length=1 release_angle=0 /\n&fit free='length gravity' sigma=1 /\n", "t azimuth", 30, still[0], 8,
    values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_NO_MINIMUM || code == KYVADLO_OK, "a bob at rest");
  for (i = 0; i < 30; i++)
    still[i][1] = 1e5*sin(1e3*i*i);
  code = kyvadlo_fit_rows("&pendulum /\n&fit free='length gravity position velocity' sigma=1e-3 /\n", "t x", 30, still[0], 8,
    values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_NO_MINIMUM || code == KYVADLO_OK, "numbers that no pendulum makes");
  code = kyvadlo_fit_rows("&pendulum release_angle=10 /\n&air linear=1e-3 /\n&fit free='length linear' sigma=1 /\n", "t x", 30,
    still[0], 8, values, sigmas, &summary, message, sizeof message);
  check(code == KYVADLO_NO_MINIMUM || code == KYVADLO_OK, "numbers that no pendulum in air makes");
  check(handled == 0, "GSL's error handler was never called");

  printf("%d passed, %d failed\n", passes, failures);
  return failures > 0;
}
