// The headers of runtime/emitted for contacts as they stand, in C, for four contacts.
#include "emitted_contacts.h"

#include <stdint.h>

#define TL_INLINE static inline
#define TL_FUNCTION static
#define TL_ZERO 0.0
#define TL_HALF 0.5
#define TL_ONE 1.0
#define TL_TWO 2.0
#define TL_TEN 10.0
#define TL_ROUNDING 0x1p-52
#define TL_CONTACT_TOLERANCE 1e-12
#define TL_TOLERANCE_OF_MANY 1e-12
#define TL_FEW_CONTACTS TL_CONTACTS
#define TL_CONTACT_SHIFT 1e-12
#define TL_LARGEST_FRICTION 1e6

typedef double real;

enum { TL_CONTACTS = kContactsOfC, TL_CONTACT_ROWS = 16 };

// Of square_root.h, which reads the bits of numbers.
#define TL_ROOT_INSTRUCTION TL_ROOT_OF_DOUBLE
typedef uint64_t TlBits;
enum { TL_FRACTION_BITS = 52, TL_SIGN_AT = 63, TL_BIAS = 1023 };

#include "emitted/number_bits.h"
//
#include "emitted/contact_solver.h"

bool solve_contacts_in_c(const double* A, const double* normals, const double* frictions, double* v,
                         double* y) {
  static TlContacts contacts;
  TlContactLaw laws[TL_CONTACTS];
  for (int32_t c = 0; c < TL_CONTACTS; ++c) {
    for (int32_t i = 0; i < 3; ++i) {
      laws[c].normal[i] = normals[(3 * c) + i];
    }
    laws[c].restitution = 0.0;
    laws[c].friction = frictions[c];
  }
  return tl_solve_contacts(&contacts, TL_CONTACTS, A, &laws[0], v, y).converged;
}
