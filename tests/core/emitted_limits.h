// What limited_torque_test.cpp and emitted_limits.c call of each other.
#pragma once
#ifdef __cplusplus
extern "C" {
#endif

void limit_torque_in_c(const void* layout, const void* limits, const double* M, const double* J_s,
                       const double* J_t, double* tau, double* f, void* result);

#ifdef __cplusplus
}
#endif
