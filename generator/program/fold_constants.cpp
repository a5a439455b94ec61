#include "program/fold_constants.hpp"

#include <cstring>
#include <utility>

namespace treeline {
namespace {

/// Identifies a constant by what all limbs have in common: its slot, or the value of an ordinary
/// constant.
std::uint64_t key_of(Expression e) {
  const LimbConstant own = limb_constant(look(e));
  std::uint64_t key = own.slot;
  if (own.slot == 0) {
    const double value = look(e).value;
    std::memcpy(&key, &value, sizeof key);
    key ^= std::uint64_t{1} << 63;
  }
  return key;
}

std::uint32_t slot_of(Op op, Expression a, Expression b) {
  std::uint64_t hash = static_cast<std::uint64_t>(op) + 1;
  for (const std::uint64_t part : {key_of(a), key_of(b), std::uint64_t{b.negative()}}) {
    hash = (hash ^ part) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29;
  }
  const auto slot = static_cast<std::uint32_t>(hash >> 16);
  return slot == 0 ? 1 : slot;
}

/// Makes the constant `value` from two constants. If one of them belongs to a limb, the result does
/// too; constants of different limbs give an ordinary one. `b` keeps its sign in the slot.
Expression fold(Op op, const DoubleDouble& value, Expression a, Expression b) {
  const LimbConstant of_a = limb_constant(look(a));
  const LimbConstant of_b = limb_constant(look(b));
  const LimbConstant& own = of_a.slot != 0 ? of_a : of_b;
  const bool mixed =
      of_a.slot != 0 && of_b.slot != 0 && (of_a.limb != of_b.limb || of_a.limbs != of_b.limbs);
  if (own.slot == 0 || mixed) {
    return {value};
  }
  const LimbConstant folded{slot_of(op, a, b), own.limb, own.limbs};
  return {Graph::current().intern(make_limb_constant(folded, value.value), value.rest), false};
}

}  // namespace

bool is_ordinary_constant(Expression e) {
  return e.is_constant() && !e.is_limb_constant();
}

Expression fold_sum(Expression a, Expression b) {
  if (a.node() == b.node()) {
    return a.negative() != b.negative() ? Expression() : Expression(2) * a;
  }
  if (key_of(b) < key_of(a)) {
    std::swap(a, b);
  }
  const bool negative = a.negative();
  a = unsigned_of(a);
  b = with_sign(b, negative);
  return with_sign(fold(Op::add, a.exact_constant() + b.exact_constant(), a, b), negative);
}

Expression fold_product(Expression a, Expression b) {
  if (key_of(b) < key_of(a)) {
    std::swap(a, b);
  }
  const bool negative = a.negative() != b.negative();
  a = unsigned_of(a);
  b = unsigned_of(b);
  for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, a}}) {
    if (is_ordinary_constant(one) && one.constant() == 1) {
      return with_sign(other, negative);
    }
  }
  return with_sign(fold(Op::mul, a.exact_constant() * b.exact_constant(), a, b), negative);
}

Expression fold_quotient(Expression a, Expression b) {
  const bool negative = a.negative() != b.negative();
  a = unsigned_of(a);
  b = unsigned_of(b);
  return with_sign(fold(Op::div, a.exact_constant() / b.exact_constant(), a, b), negative);
}

}  // namespace treeline
