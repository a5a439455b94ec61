#pragma once

#include <string>

#include "../own_folder.hpp"
#include "run_program.hpp"

namespace treeline::test {

/// A test that runs the program in a folder of its own.
class ProgramTest : public OwnFolder {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return run_program(root_, arguments);
  }
};

}  // namespace treeline::test
