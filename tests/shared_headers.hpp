#pragma once
// What many tests include, parsed once for all of them: see TREELINE_PRECOMPILE_HEADERS in
// CMakeLists.txt. No test includes it. A test that means another thing by a name of these does not
// reuse it: DISABLE_PRECOMPILE_HEADERS.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <random>
#include <regex>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "bounds/bound_rounding.hpp"
#include "check/check.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "generation/generate_code.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "oracle/reference.hpp"
#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "program/evaluate.hpp"
#include "random_mechanism.hpp"
#include "random_state.hpp"
#include "recursion/routes/trace_function.hpp"
