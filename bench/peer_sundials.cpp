#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cstdio>
#include <cstdlib>

#include "peer_rhs.hpp"

namespace physim::bench {
namespace {

constexpr double kLastTime = 60;  // [s]
constexpr long kMostSteps = 1'000'000;

int rhs(double, N_Vector y, N_Vector slope, void* task) {
  auto* flown = static_cast<PeerTask*>(task);
  peer_rhs(*flown->model, NV_DATA_S(y), NV_DATA_S(slope));
  ++flown->evaluations;
  return 0;
}

int range_line(double, N_Vector y, double* value, void* task) {
  value[0] = NV_Ith_S(y, 0) - static_cast<PeerTask*>(task)->range;
  return 0;
}

void must(int flag, const char* what) {
  if (flag >= 0) return;
  std::fprintf(stderr, "SUNDIALS: %s failed with %d\n", what, flag);
  std::exit(1);
}

PeerEnd end_of(double t, N_Vector y) { return {t, {NV_Ith_S(y, 0), NV_Ith_S(y, 1), NV_Ith_S(y, 2)}}; }

void fly_cvode(PeerTask& task, int method) {
  SUNContext context = nullptr;
  must(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  N_Vector y = N_VNew_Serial(6, context);
  for (int i = 0; i < 6; ++i) NV_Ith_S(y, i) = 0;
  void* cvode = CVodeCreate(method, context);
  must(CVodeInit(cvode, rhs, 0, y), "CVodeInit");
  must(CVodeSetUserData(cvode, &task), "CVodeSetUserData");
  must(CVodeSStolerances(cvode, task.tolerance, task.tolerance), "CVodeSStolerances");
  must(CVodeRootInit(cvode, 1, range_line), "CVodeRootInit");
  must(CVodeSetMaxNumSteps(cvode, kMostSteps), "CVodeSetMaxNumSteps");
  SUNNonlinearSolver fixed_point = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  if (method == CV_ADAMS) {
    fixed_point = SUNNonlinSol_FixedPoint(y, 0, context);
    must(CVodeSetNonlinearSolver(cvode, fixed_point), "CVodeSetNonlinearSolver");
  } else {
    matrix = SUNDenseMatrix(6, 6, context);
    linear = SUNLinSol_Dense(y, matrix, context);
    must(CVodeSetLinearSolver(cvode, linear, matrix), "CVodeSetLinearSolver");
  }
  for (std::size_t i = 0; i < task.shots.size(); ++i) {
    peer_launch(task.shots[i], NV_DATA_S(y));
    must(CVodeReInit(cvode, 0, y), "CVodeReInit");
    double t = 0;
    must(CVode(cvode, kLastTime, y, &t, CV_NORMAL), "CVode");
    long steps = 0;
    CVodeGetNumSteps(cvode, &steps);
    task.steps += steps;
    task.ends[i] = end_of(t, y);
  }
  CVodeFree(&cvode);
  if (fixed_point) SUNNonlinSolFree(fixed_point);
  if (linear) SUNLinSolFree(linear);
  if (matrix) SUNMatDestroy(matrix);
  N_VDestroy(y);
  SUNContext_Free(&context);
}

}  // namespace

void fly_cvode_adams(PeerTask& task) { fly_cvode(task, CV_ADAMS); }
void fly_cvode_bdf(PeerTask& task) { fly_cvode(task, CV_BDF); }

void fly_arkode_dopri5(PeerTask& task) {
  SUNContext context = nullptr;
  must(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  N_Vector y = N_VNew_Serial(6, context);
  for (int i = 0; i < 6; ++i) NV_Ith_S(y, i) = 0;
  void* arkode = ERKStepCreate(rhs, 0, y, context);
  must(ERKStepSetUserData(arkode, &task), "ERKStepSetUserData");
  must(ERKStepSStolerances(arkode, task.tolerance, task.tolerance), "ERKStepSStolerances");
  must(ERKStepSetTableNum(arkode, ARKODE_DORMAND_PRINCE_7_4_5), "ERKStepSetTableNum");
  must(ERKStepSetInterpolantDegree(arkode, 5), "ERKStepSetInterpolantDegree");
  must(ERKStepRootInit(arkode, 1, range_line), "ERKStepRootInit");
  must(ERKStepSetMaxNumSteps(arkode, kMostSteps), "ERKStepSetMaxNumSteps");
  for (std::size_t i = 0; i < task.shots.size(); ++i) {
    peer_launch(task.shots[i], NV_DATA_S(y));
    must(ERKStepReInit(arkode, rhs, 0, y), "ERKStepReInit");
    must(ERKStepSetInitStep(arkode, peer_first_step(task.tolerance)), "ERKStepSetInitStep");
    double t = 0;
    must(ERKStepEvolve(arkode, kLastTime, y, &t, ARK_NORMAL), "ERKStepEvolve");
    long steps = 0;
    ERKStepGetNumSteps(arkode, &steps);
    task.steps += steps;
    task.ends[i] = end_of(t, y);
  }
  ERKStepFree(&arkode);
  N_VDestroy(y);
  SUNContext_Free(&context);
}

}  // namespace physim::bench
