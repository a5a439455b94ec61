#include <fmt/format.h>

#include <vector>

#include "emission/print_parts.hpp"
#include "safety/describe_safety.hpp"

namespace treeline {
namespace {

struct Deviation {
  const char* rule;
  const char* what;
  const char* why;
};

const char* const kTable = "\n| rule | deviation | reason |\n|---|---|---|\n";

std::string print_table(const std::vector<Deviation>& deviations) {
  std::string text = kTable;
  for (const Deviation& row : deviations) {
    text += fmt::format("| {} | {} | {} |\n", row.rule, row.what, row.why);
  }
  return text;
}

std::string describe_profile() {
  return fmt::format(
      "Written by `profile: misra`: suffixes in capitals, every operation within another in "
      "parentheses, numbers but 0, 1/2, 1 and 2 with names, one statement a line, at most {} "
      "statements a function; no builtin, no extension of a compiler, no macro but guards of "
      "headers, where the table has none. The headers read macros that the compiler defines, to "
      "stop it at flags that change "
      "results.\n\n",
      kMostStatements);
}

std::string describe_c(const Scene& scene) {
  const bool misra = scene.profile == Profile::misra;
  std::vector<Deviation> deviations = {
      {"2.3 (advisory)", "the type `NAME_real` is not used by the code itself",
       "it is for callers"},
      {"2.4 (advisory)", "enumerations without a name count as unused tags",
       "cppcheck counts them; they are integer constants"}};
  if (!misra) {
    deviations.push_back({"2.5 (advisory)", "the macro of a square-root instruction may be unused",
                          "the portable root was asked for"});
    deviations.push_back({"19.2 (advisory)", "a union takes the bits of a number",
                          "a copy by `memcpy` needs a library"});
  }
  if (scene.optimize == Optimize::size) {
    deviations.push_back({"8.9 (advisory)",
                          "a table of links in NAME_links.h may be used by one function alone",
                          "tables stand in a header, since functions that loop share them"});
  } else if (scene.controller) {
    deviations.push_back({"8.9 (advisory)",
                          "a table in controller_robot.h may be used by one function alone",
                          "what differs between robots stands in one header"});
  }
  std::string text = misra ? describe_profile() : std::string();
  text += fmt::format(
      "`cppcheck --addon=misra` finds violations of {} advisory rules of MISRA C:2012 and of no "
      "other. cppcheck does not check all rules of the standard.\n",
      deviations.size());
  text += print_table(deviations);
  if (!misra) {
    text +=
        "\nRules that cppcheck does not check: arguments are declared `restrict static`, against "
        "8.14 (required) and 17.6 (mandatory), and where there is a square root, a builtin or an "
        "instruction takes it, against 1.2 (advisory). `profile: misra` has none of these.\n";
  }
  if (scene.controller) {
    text +=
        "\ncontroller_mailbox.h reads and writes shared numbers by builtins of GCC and Clang, "
        "against "
        "1.2 (advisory): C99 has no atomic operations. Other compilers need `<stdatomic.h>` of "
        "C11.\n";
  }
  return text;
}

/// Adds the deviations of the controller by `profile: misra`, beside those of the functions.
void add_controller(std::vector<Deviation>& deviations) {
  deviations.push_back(
      {"4.1.1 (required), 19.0.2 (required)",
       "controller_mailbox.hpp reads and writes shared numbers by builtins of GCC and Clang, "
       "with `<atomic>` for other compilers",
       "toolchains for microcontrollers that have no library of C++ lack `<atomic>`"});
  deviations.push_back(
      {"10.2.1 (required), 10.2.2 (advisory)",
       "enumerations of NAME_controller.h are unscoped and have no underlying type",
       "the header is for C as well"});
  deviations.push_back({"10.2.3 (required)", "the step reads and writes their values as integers",
                        "members of the header's structs are integers of a stated size"});
}

std::string describe_cpp(const Scene& scene) {
  const bool misra = scene.profile == Profile::misra;
  std::vector<Deviation> deviations = {
      {"11.3.1 (advisory)", "arguments and locals are arrays of fixed size",
       "they are passed as references to arrays, which keep their sizes: no pointer, no decay"},
      {"11.6.1 (advisory)",
       "results of sines and cosines, and values that parts of a function "
       "share, are declared before they are assigned",
       "every one is assigned once, before it is read, without a branch between"},
      {"0.2.1 (advisory)", "constants of the headers may be unused in a translation unit",
       "they are for callers"},
      {"6.0.3 (advisory)", "`<stdint.h>` declares its types in the global namespace",
       "toolchains for microcontrollers that have no library of C++ lack `<cstdint>`"}};
  if (!misra) {
    const std::vector<Deviation> plain = {
        {"4.1.1 (required)", "`__restrict`, attributes, vectors and builtins of GCC and Clang",
         "speed; each stands behind a check of the compiler, with C++17 for others"},
        {"6.9.2 (advisory)", "`int` for sizes and indices", "they are small"},
        {"8.0.1 (advisory)", "products in sums stand without parentheses", "they bind tighter"},
        {"8.2.5 (required)", "`reinterpret_cast` takes the bits of numbers in sin_cos.hpp",
         "C++17 has no `bit_cast`, and a copy by `memcpy` needs a library"},
        {"19.0.2 (required)",
         "macros with arguments for instructions of square roots, where there "
         "are any",
         "the instruction depends on the target"},
        {"19.6.1 (advisory)", "`#pragma` of warnings",
         "g++ warns of the sign of array bounds that are template parameters"}};
    deviations.insert(deviations.end(), plain.begin(), plain.end());
  }
  if (misra && scene.controller) add_controller(deviations);
  std::string text = misra ? describe_profile() : std::string();
  text +=
      "Compared by hand with the rules of MISRA C++:2023: no free tool checks them. What rules say "
      "of classes, exceptions, the heap and the library does not apply: the code has none.";
  const bool has_pointers =
      scene.has_limits() || scene.controller || scene.optimize == Optimize::size;
  text += misra && !has_pointers ? " Nor has it pointers.\n" : "\n";
  if (misra && has_pointers) {
    text +=
        "Limited control, the controller and loops over links pass arrays and rows of matrices by "
        "pointers: none decays from an array (7.11.2), and none leaves its array (8.7.1), since "
        "loops end at its size.\n";
  }
  text += print_table(deviations);
  text += misra
              ? "\n`language: c` gives C99 of the same bits, which cppcheck compares with MISRA "
                "C:2012.\n"
              : "\nNAME_calls.hpp and NAME_eigen.hpp, damped, limited and batched "
                "functions and the controller were not compared. `profile: misra` leaves out what "
                "is required above, and of them the first two and batched functions.\n";
  return text;
}

}  // namespace

std::string describe_deviations(const Scene& scene) {
  return scene.language == Language::c ? describe_c(scene) : describe_cpp(scene);
}

}  // namespace treeline
