#include "text/terminal_columns.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace treeline {
namespace {

constexpr std::size_t kPageColumns = 100;
constexpr std::size_t kFewest = 60;  ///< narrower tables would be all folds

std::size_t& measured() {
  static std::size_t columns = 0;
  return columns;
}

}  // namespace

std::size_t terminal_columns() {
  return measured();
}

std::size_t page_columns() {
  return measured() == 0 ? kPageColumns : std::min(kPageColumns, measured());
}

void fit_to_terminal() {
  winsize size{};
  const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  measured() = is_known ? std::max<std::size_t>(size.ws_col, kFewest) : 0;
}

}  // namespace treeline
