#include <array>

#include "target/target.hpp"

namespace treeline {
namespace {

constexpr const char* kArmPackage = "gcc-arm-none-eabi";
constexpr const char* kRiscvPackage = "gcc-riscv64-unknown-elf";
constexpr const char* kSystemArm = "qemu-system-arm";
constexpr const char* kSystemMisc = "qemu-system-misc";

/// A board of Arm's MPS2 and MPS3 series.
constexpr Board arm_board(const char* machine, const char* linker, int clock_mhz) {
  return {BoardKind::cortex_m, kSystemArm, machine, kSystemArm, linker, clock_mhz};
}

// Code and data of these boards. What is behind `data` holds the states.
constexpr const char* kMps2 =
    "--defsym=code_begin=0 --defsym=data_begin=0x20000000 --defsym=data_size=0x400000 "
    "--defsym=bulk_begin=0x21000000";
constexpr const char* kMps2WithM7 =
    "--defsym=code_begin=0 --defsym=data_begin=0x20000000 --defsym=data_size=0x400000 "
    "--defsym=bulk_begin=0x60000000";
constexpr const char* kMps2Secure =
    "--defsym=code_begin=0x10000000 --defsym=data_begin=0x38000000 --defsym=data_size=0x200000 "
    "--defsym=bulk_begin=0x38200000";
constexpr const char* kMps3 =
    "--defsym=code_begin=0 --defsym=data_begin=0x20000000 --defsym=data_size=0x80000 "
    "--defsym=bulk_begin=0x60000000";
constexpr const char* kVirt =
    "--defsym=code_begin=0x80000000 --defsym=data_begin=0x81000000 --defsym=data_size=0x400000 "
    "--defsym=bulk_begin=0x82000000";
constexpr const char* kVirtArm =
    "--defsym=code_begin=0x40100000 --defsym=data_begin=0x41000000 --defsym=data_size=0x400000 "
    "--defsym=bulk_begin=0x42000000";

constexpr CycleCosts kCortexM0{
    1, 2, 3, 1, 1, 1, 1, "Arm's manual of the Cortex-M0, memory without wait states"};
constexpr CycleCosts kCortexM3{
    1, 2, 3, 1, 1, 1, 1, "Arm's manual of the Cortex-M3, memory without wait states"};
constexpr CycleCosts kCortexM4{
    1, 2, 3, 1, 3, 14, 14, "Arm's manual of the Cortex-M4, memory without wait states"};
constexpr CycleCosts kCortexM33{1, 2,  3,  1,
                                3, 14, 14, "assumed as on a Cortex-M4: Arm publishes none"};
constexpr CycleCosts kCortexM7{
    0.6, 1,  1,  1,
    1,   16, 30, "assumed: two instructions start together, a quotient waits; Arm publishes none"};
constexpr CycleCosts kCortexM55{
    1, 1,  2,  1,
    2, 14, 30, "assumed: one instruction a cycle, a quotient waits; Arm publishes none"};
constexpr CycleCosts kInOrder{
    1, 1,  2,  1,
    1, 20, 30, "assumed: a core that starts one instruction a cycle, with a pipelined unit"};
constexpr CycleCosts kTwoInOrder{
    0.6, 1,  1,  1,
    1,   12, 22, "assumed: a core that starts two instructions a cycle in order, as a Cortex-A53"};

// What operations cost, in sums. Where they are emulated: fitted to the instructions that PUMA's
// eleven functions take in QEMU, weighted by cycles as above, which they give within 3 %.
constexpr const char* kEmulated = "fitted to emulated operations in QEMU";
constexpr OperationCosts kFloatOnM0{1.3, 2.6, 39, 0, 1, kEmulated};
constexpr OperationCosts kDoubleOnM0{2.4, 2.5, 86, 0, 1, kEmulated};
constexpr OperationCosts kFloatOnM3{0.27, 2.6, 25, 0, 1, kEmulated};
constexpr OperationCosts kDoubleOnM3{0.43, 7.9, 39, 0, 1, kEmulated};
constexpr OperationCosts kDoubleOnM4{0.6, 7.4, 43, 0, 1, kEmulated};
constexpr OperationCosts kDoubleOnM33{0.9, 7.7, 51, 0, 1, kEmulated};
constexpr OperationCosts kDoubleOnRv32{2.0, 2.5, 79, 0, 1, kEmulated};
// Where there are instructions: a sum with its share of loads and stores takes 1.4 to 2.5 cycles in
// QEMU's counts, an angle 76 to 122 (with lanes 11 and 45), and a quotient what the table above
// says. Cores without a long pipeline do not wait for operands.
constexpr const char* kInstructions = "by cycles of their instructions, counted in QEMU";
constexpr OperationCosts kFloatOnM4{1, 7, 50, 0, 1, kInstructions};
constexpr OperationCosts kFloatOnM7{1, 9.5, 43, 1, 1, kInstructions};
constexpr OperationCosts kDoubleOnM7{1, 17, 59, 1, 1, kInstructions};
constexpr OperationCosts kFloatOnM55{1, 8.5, 45, 0, 1, kInstructions};
constexpr OperationCosts kDoubleOnM55{1, 14, 56, 0, 1, kInstructions};
constexpr OperationCosts kFloatOnRiscv{1, 10, 37, 1, 1, kInstructions};
constexpr OperationCosts kDoubleOnRv64{1, 12.5, 37, 1, 1, kInstructions};
constexpr OperationCosts kFloatOnA53{1, 9, 8, 1, 4, kInstructions};
constexpr OperationCosts kDoubleOnA53{1, 15.5, 30, 1, 2, kInstructions};

// What code takes, in bytes.
constexpr CodeSizes kFloatOnThumb{5.4, 540, 1};
constexpr CodeSizes kDoubleOnThumb{7, 860, 1.22};
constexpr CodeSizes kFloatByCalls{9.1, 750, 1.13};
constexpr CodeSizes kDoubleByCalls{14.5, 1450, 1.64};
constexpr CodeSizes kFloatInRv32{5.7, 860, 1.21};
constexpr CodeSizes kDoubleInRv32{20.8, 2160, 2.3};
constexpr CodeSizes kFloatInRv64{6.6, 800, 1.3};
constexpr CodeSizes kDoubleInRv64{5.8, 1220, 1.31};
constexpr CodeSizes kFloatInA64{6.8, 1100, 1.36};
constexpr CodeSizes kDoubleInA64{7.3, 1830, 1.42};
constexpr CodeSizes kFloatInSse{10.2, 1010, 1.77};
constexpr CodeSizes kDoubleInSse{11.1, 2060, 1.89};
constexpr CodeSizes kFloatInAvx2{8.6, 930, 1.51};
constexpr CodeSizes kDoubleInAvx2{10.6, 1110, 1.63};
constexpr CodeSizes kFloatInAvx512{7.3, 1050, 1.5};
constexpr CodeSizes kDoubleInAvx512{7.7, 1440, 1.6};

/// A target without a board, whose costs are those that `OperationCosts` has.
constexpr Target on_this_machine(const char* name, const char* about, const char* flags,
                                 int vector_bytes, CodeSizes float_sizes, CodeSizes double_sizes) {
  Target target{name, about, "", "g++", flags, FloatUnit::single_and_double, vector_bytes};
  target.float_sizes = float_sizes;
  target.double_sizes = double_sizes;
  return target;
}

constexpr auto kTargets = std::to_array<Target>({
    on_this_machine("generic", "any processor", "", 64, kFloatInSse, kDoubleInSse),
    {"cortex-m0", "Arm Cortex-M0, no floating-point unit", "arm-none-eabi-", kArmPackage,
     "-mcpu=cortex-m0 -mthumb -mfloat-abi=soft", FloatUnit::none, 0, false,
     // QEMU's only board with this core has 16 KB of memory. A Cortex-M3 executes the same code.
     arm_board("-M mps2-an385", kMps2, 25), kCortexM0, kFloatOnM0, kDoubleOnM0, kFloatByCalls,
     kDoubleByCalls},
    {"cortex-m3", "Arm Cortex-M3, no floating-point unit", "arm-none-eabi-", kArmPackage,
     "-mcpu=cortex-m3 -mthumb -mfloat-abi=soft", FloatUnit::none, 0, false,
     arm_board("-M mps2-an385", kMps2, 25), kCortexM3, kFloatOnM3, kDoubleOnM3, kFloatByCalls,
     kDoubleByCalls},
    {"cortex-m4f", "Arm Cortex-M4 with a single-precision unit", "arm-none-eabi-", kArmPackage,
     "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16", FloatUnit::single_only, 0, false,
     arm_board("-M mps2-an386", kMps2, 25), kCortexM4, kFloatOnM4, kDoubleOnM4, kFloatOnThumb,
     kDoubleByCalls},
    {"cortex-m7", "Arm Cortex-M7 with a double-precision unit", "arm-none-eabi-", kArmPackage,
     "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16", FloatUnit::single_and_double, 0,
     false, arm_board("-M mps2-an500", kMps2WithM7, 25), kCortexM7, kFloatOnM7, kDoubleOnM7,
     kFloatOnThumb, kDoubleOnThumb},
    {"cortex-m33", "Arm Cortex-M33 with a single-precision unit", "arm-none-eabi-", kArmPackage,
     "-mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16", FloatUnit::single_only, 0,
     false, arm_board("-M mps2-an505", kMps2Secure, 20), kCortexM33, kFloatOnM4, kDoubleOnM33,
     kFloatOnThumb, kDoubleByCalls},
    // Its vectors hold no doubles, and to collect four floats takes more than it saves: where g++
    // does so by itself, humanoid24's mass matrix takes 12 % more instructions and twice the stack.
    {"cortex-m55", "Arm Cortex-M55 with a double-precision unit", "arm-none-eabi-", kArmPackage,
     "-mcpu=cortex-m55 -mthumb -mfloat-abi=hard -fno-tree-slp-vectorize",
     FloatUnit::single_and_double, 0, false, arm_board("-M mps3-an547", kMps3, 32), kCortexM55,
     kFloatOnM55, kDoubleOnM55, kFloatOnThumb, kDoubleOnThumb},
    {"rv32imfc", "32-bit RISC-V with a single-precision unit", "riscv64-unknown-elf-",
     kRiscvPackage, "-march=rv32imfc -mabi=ilp32f", FloatUnit::single_only, 0, false,
     Board{BoardKind::riscv, "qemu-system-riscv32", "-M virt -bios none", kSystemMisc, kVirt, 0},
     kInOrder, kFloatOnRiscv, kDoubleOnRv32, kFloatInRv32, kDoubleInRv32},
    {"rv64gc", "64-bit RISC-V with a double-precision unit", "riscv64-unknown-elf-", kRiscvPackage,
     "-march=rv64gc -mabi=lp64d -mcmodel=medany", FloatUnit::single_and_double, 0, true,
     Board{BoardKind::riscv, "qemu-system-riscv64", "-M virt -bios none", kSystemMisc, kVirt, 0},
     kInOrder, kFloatOnRiscv, kDoubleOnRv64, kFloatInRv64, kDoubleInRv64},
    {"aarch64", "64-bit Arm", "aarch64-linux-gnu-", "g++-aarch64-linux-gnu", "-march=armv8-a",
     FloatUnit::single_and_double, 16, true,
     Board{BoardKind::aarch64, "qemu-system-aarch64", "-M virt -cpu cortex-a53 -nic none",
           kSystemArm, kVirtArm, 0},
     kTwoInOrder, kFloatOnA53, kDoubleOnA53, kFloatInA64, kDoubleInA64},
    on_this_machine("x86-64-v3", "64-bit x86 with AVX2 and fused multiply-add", "-march=x86-64-v3",
                    32, kFloatInAvx2, kDoubleInAvx2),
    on_this_machine("x86-64-v4", "64-bit x86 with AVX-512", "-march=x86-64-v4", 64, kFloatInAvx512,
                    kDoubleInAvx512),
});

}  // namespace

std::span<const Target> all_targets() {
  return kTargets;
}

}  // namespace treeline
