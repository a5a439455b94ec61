#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "record.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Where the firmware's sources are: the generated controller, runtime/, this folder.
struct FirmwareSources {
  std::filesystem::path generated, runtime, own;
};

/// What a run has streamed.
struct FirmwareRun {
  std::string states;  ///< the bytes of all records
  std::uint32_t servo_bytes = 0;
  std::uint32_t least = 0, most = 0;  ///< instructions of a cycle; 0 where they are not counted
  std::uint32_t stack = 0;            ///< bytes that a cycle has written to
};

/// Compiles the firmware for the target, as all its code is compiled, and runs it on the board in
/// QEMU. Errors: a tool is missing, a source does not compile or link, the program fails.
std::optional<FirmwareRun> run_on_board(const std::string& target, const FirmwareSources& sources,
                                        Diagnostics& diagnostics);

/// Compiles it with `compiler` for this machine and runs it here.
std::optional<FirmwareRun> run_on_host(const std::string& compiler, const FirmwareSources& sources,
                                       Diagnostics& diagnostics);

/// The records of a run.
std::vector<Record> read_records(const FirmwareRun& run);

}  // namespace treeline
