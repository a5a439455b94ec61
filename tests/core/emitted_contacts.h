// What contact_solver_test.cpp calls of emitted_contacts.c.
#pragma once

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { kContactsOfC = 4 };

/// Impulses at four contacts that do not bounce; whether they converged.
bool solve_contacts_in_c(const double* A, const double* normals, const double* frictions, double* v,
                         double* y);

#ifdef __cplusplus
}
#endif
