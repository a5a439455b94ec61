// The table of quantities. Would catch: a symbol that is not found again, a function that does not
// begin with q or takes something twice, a quantity without unit or range.
#include "functions/quantity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "functions/function.hpp"

namespace treeline {
namespace {

TEST(Quantities, AreFoundByTheirSymbols) {
  for (const QuantityInfo& row : kQuantities) {
    EXPECT_EQ(find_quantity(row.symbol), row.quantity) << row.symbol;
    EXPECT_NE(std::string(row.unit), "") << row.symbol;
    EXPECT_NE(std::string(row.meaning), "") << row.symbol;
    EXPECT_GT(row.range, 0) << row.symbol;
  }
  EXPECT_EQ(find_quantity("x"), std::nullopt);
}

TEST(Quantities, AreTakenOnceAndAfterCoordinates) {
  for (const FunctionInfo& row : kFunctions) {
    ASSERT_GT(row.inputs.count, 0U) << row.name;
    EXPECT_EQ(*row.inputs.begin(), Quantity::q) << row.name;
    for (const Quantity quantity : row.inputs) {
      EXPECT_EQ(std::count(row.inputs.begin(), row.inputs.end(), quantity), 1) << row.name;
    }
  }
  EXPECT_TRUE(takes_external_forces(Function::control_torque));
  EXPECT_FALSE(takes_external_forces(Function::gravity));
}

TEST(Quantities, AreSometimesTaken) {
  for (const QuantityInfo& row : kQuantities) {
    if (row.quantity == Quantity::sin_q || row.quantity == Quantity::cos_q) continue;  // for q
    const bool taken =
        std::any_of(kFunctions.begin(), kFunctions.end(),
                    [&](const FunctionInfo& each) { return takes(each.function, row.quantity); });
    EXPECT_TRUE(taken) << row.symbol;
  }
}

}  // namespace
}  // namespace treeline
