/* CVODE's Adams methods with fixed-point iteration: from y over [0, end_s], absolute
 * tolerance `tolerance` on every component. Returns 0, or CVODE's error code. Written for
 * SUNDIALS 6 and 7. */
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#if SUNDIALS_VERSION_MAJOR < 7
#define NO_COMMUNICATOR NULL
#else
#define NO_COMMUNICATOR SUN_COMM_NULL
#endif

typedef void (*equations)(void *context, const double *y, double *dydt);

struct call {
  equations f;
  void *context;
};

static int right_hand_side(sunrealtype t, N_Vector y, N_Vector dydt, void *data)
{
  const struct call *call = data;
  (void)t;
  call->f(call->context, N_VGetArrayPointer(y), N_VGetArrayPointer(dydt));
  return 0;
}

int cageless_bench_cvode(equations f, void *context, long dimension, double *y,
                         double end_s, double tolerance)
{
  struct call call = {f, context};
  SUNContext sun = NULL;
  if (SUNContext_Create(NO_COMMUNICATOR, &sun)) return -1000;
  N_Vector vector = N_VMake_Serial(dimension, y, sun);
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(vector, 0, sun);
  void *cvode = CVodeCreate(CV_ADAMS, sun);
  sunrealtype reached = 0;
  int code = CVodeInit(cvode, right_hand_side, 0, vector);
  if (code == CV_SUCCESS) code = CVodeSStolerances(cvode, 0, tolerance);
  if (code == CV_SUCCESS) code = CVodeSetUserData(cvode, &call);
  if (code == CV_SUCCESS) code = CVodeSetNonlinearSolver(cvode, iteration);
  if (code == CV_SUCCESS) code = CVodeSetMaxNumSteps(cvode, 1000000000);
  if (code == CV_SUCCESS) code = CVodeSetStopTime(cvode, end_s);
  if (code == CV_SUCCESS) code = CVode(cvode, end_s, vector, &reached, CV_NORMAL);
  CVodeFree(&cvode);
  SUNNonlinSolFree(iteration);
  N_VDestroy(vector);
  SUNContext_Free(&sun);
  return code < 0 ? code : 0;
}

const char *cageless_bench_sundials(void) { return SUNDIALS_VERSION; }
