#include <algorithm>
#include <array>
#include <charconv>

#include "board/measure_objects.hpp"

namespace treeline {
namespace {

bool begins_with_any(std::string_view text, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view each) { return text.starts_with(each); });
}

bool is_any(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

/// Whether it works on doubles: by its suffix, or on 64-bit Arm by its registers.
bool is_double(std::string_view mnemonic, std::string_view operands) {
  return mnemonic.ends_with(".f64") || mnemonic.ends_with(".d") || operands.starts_with("d") ||
         operands.find(".2d") != std::string_view::npos;
}

bool is_branch(std::string_view word) {
  constexpr std::array kConditions = {"eq", "ne", "cs", "cc", "mi", "pl", "vs",
                                      "vc", "hi", "ls", "ge", "lt", "gt", "le"};
  if (is_any(word, {"b", "bl", "bx", "blx", "br", "blr", "ret", "cbz", "cbnz", "tbz", "tbnz", "j",
                    "jal", "jr", "jalr", "le", "dls"}) ||
      begins_with_any(word, {"b.", "beq", "bne", "blt", "bge", "bgt", "ble"})) {
    return true;
  }
  return word.size() == 3 && word.front() == 'b' &&
         std::find(kConditions.begin(), kConditions.end(), word.substr(1)) != kConditions.end();
}

double cycles_of(InstructionKind kind, const CycleCosts& costs) {
  switch (kind) {
    case InstructionKind::memory:
      return costs.memory;
    case InstructionKind::branch:
      return costs.branch;
    case InstructionKind::arithmetic:
      return costs.arithmetic;
    case InstructionKind::fused:
      return costs.fused;
    case InstructionKind::divide_float:
      return costs.divide_float;
    case InstructionKind::divide_double:
      return costs.divide_double;
    case InstructionKind::other:
      break;
  }
  return costs.other;
}

/// Number behind the letter of a register such as s16.
int number_of(std::string_view name) {
  int number = 0;
  const std::size_t digit = std::min(name.find_first_of("0123456789"), name.size());
  std::from_chars(name.data() + digit, name.data() + name.size(), number);
  return number;
}

}  // namespace

InstructionKind kind_of_instruction(std::string_view mnemonic, std::string_view operands) {
  const std::string_view word = mnemonic.substr(0, mnemonic.find('.'));
  if (begins_with_any(word, {"vdiv", "vsqrt", "fdiv", "fsqrt"})) {
    return is_double(mnemonic, operands) ? InstructionKind::divide_double
                                         : InstructionKind::divide_float;
  }
  if (begins_with_any(word, {"vfm", "vfnm", "vmla", "vmls", "fmadd", "fmsub", "fnmadd", "fnmsub",
                             "fmla", "fmls"})) {
    return InstructionKind::fused;
  }
  if (is_any(word, {"vadd", "vsub", "vmul", "vnmul", "fadd", "fsub", "fmul", "fnmul"})) {
    return InstructionKind::arithmetic;
  }
  if (begins_with_any(word, {"ldr", "ldm", "ldp", "str", "stm", "stp", "ldur", "stur", "vldr",
                             "vldm", "vstr", "vstm", "vpush", "vpop"}) ||
      is_any(word, {"push", "pop", "lw", "sw",  "ld",  "sd", "flw", "fsw", "fld", "fsd",
                    "lb",   "lbu", "lh", "lhu", "lwu", "sb", "sh",  "ld1", "st1", "ld1r"})) {
    return InstructionKind::memory;
  }
  return is_branch(mnemonic) || is_branch(word) ? InstructionKind::branch : InstructionKind::other;
}

int count_registers(std::string_view operands) {
  const std::size_t open = operands.find('{');
  const std::size_t close = operands.find('}', open);
  if (open == std::string_view::npos || close == std::string_view::npos) return 1;
  std::string_view list = operands.substr(open + 1, close - open - 1);
  int count = 0;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    const std::string_view item = list.substr(0, end);
    const std::size_t dash = item.find('-');
    count += dash == std::string_view::npos
                 ? 1
                 : number_of(item.substr(dash + 1)) - number_of(item.substr(0, dash)) + 1;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return std::max(1, count);
}

double mean_cycles(std::string_view listing, const CycleCosts& costs) {
  double cycles = 0;
  int count = 0;
  while (!listing.empty()) {  // address, tab, code, tab, mnemonic, tab, operands
    const std::size_t end = std::min(listing.find('\n'), listing.size());
    std::string_view line = listing.substr(0, end);
    listing.remove_prefix(std::min(end + 1, listing.size()));
    const std::size_t code = line.find(":\t");
    const std::size_t before = code == std::string_view::npos ? code : line.find('\t', code + 2);
    if (before == std::string_view::npos) continue;
    line.remove_prefix(before + 1);
    const std::size_t tab = std::min(line.find('\t'), line.size());
    const std::string_view mnemonic = line.substr(0, tab);
    if (mnemonic.starts_with(".")) continue;  // a constant among the code
    const std::string_view operands = line.substr(std::min(tab + 1, line.size()));
    const InstructionKind kind = kind_of_instruction(mnemonic, operands);
    const int registers = kind == InstructionKind::memory ? count_registers(operands) : 1;
    cycles += cycles_of(kind, costs) * registers;
    ++count;
  }
  return count == 0 ? 1 : cycles / count;
}

}  // namespace treeline
