/* CVODE from y over [0, end_s], absolute tolerance `tolerance` on every component: Adams methods
 * with fixed-point iteration, or backward differentiation with Newton's method and a dense
 * Jacobian by finite differences. Calls `each_step` after every step. Returns 0, or CVODE's error
 * code. Written for SUNDIALS 6 and 7. */
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#if SUNDIALS_VERSION_MAJOR < 7
#define NO_COMMUNICATOR NULL
#else
#define NO_COMMUNICATOR SUN_COMM_NULL
#endif

typedef void (*equations)(void *context, const double *y, double *dydt);
typedef void (*step_end)(void *context, double t, const double *y);

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

int cageless_bench_cvode(equations f, step_end each_step, void *context, int bdf, long dimension,
                         double *y, double end_s, double tolerance)
{
  struct call call = {f, context};
  SUNContext sun = NULL;
  if (SUNContext_Create(NO_COMMUNICATOR, &sun)) return -1000;
  N_Vector vector = N_VMake_Serial(dimension, y, sun);
  SUNNonlinearSolver iteration = NULL;
  SUNMatrix jacobian = NULL;
  SUNLinearSolver linear = NULL;
  void *cvode = CVodeCreate(bdf ? CV_BDF : CV_ADAMS, sun);
  sunrealtype reached = 0;
  int code = CVodeInit(cvode, right_hand_side, 0, vector);
  if (code == CV_SUCCESS) code = CVodeSStolerances(cvode, 0, tolerance);
  if (code == CV_SUCCESS) code = CVodeSetUserData(cvode, &call);
  if (code == CV_SUCCESS && bdf) {
    jacobian = SUNDenseMatrix(dimension, dimension, sun);
    linear = SUNLinSol_Dense(vector, jacobian, sun);
    code = CVodeSetLinearSolver(cvode, linear, jacobian);
  } else if (code == CV_SUCCESS) {
    iteration = SUNNonlinSol_FixedPoint(vector, 0, sun);
    code = CVodeSetNonlinearSolver(cvode, iteration);
  }
  if (code == CV_SUCCESS) code = CVodeSetMaxNumSteps(cvode, 1000000000);
  if (code == CV_SUCCESS) code = CVodeSetStopTime(cvode, end_s);
  while (code == CV_SUCCESS && reached < end_s) {
    code = CVode(cvode, end_s, vector, &reached, CV_ONE_STEP);
    if (code >= 0) each_step(context, reached, y);
  }
  CVodeFree(&cvode);
  if (iteration) SUNNonlinSolFree(iteration);
  if (linear) SUNLinSolFree(linear);
  if (jacobian) SUNMatDestroy(jacobian);
  N_VDestroy(vector);
  SUNContext_Free(&sun);
  return code < 0 ? code : 0;
}

const char *cageless_bench_sundials(void) { return SUNDIALS_VERSION; }
