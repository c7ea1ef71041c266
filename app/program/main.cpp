#include "app/cli/program.h"
#include "app/headless/interrupt.h"
#include "app/window/window_program.h"

#include <Eigen/Core>

namespace {

/// Products of matrices are cut into blocks that fit the caches, by default those of this processor, and
/// another cut sums in another order: the last digits of a result would be those of the machine.
void fixBlocksOfProducts() {
    constexpr std::ptrdiff_t Kilobyte = 1024;
    Eigen::setCpuCacheSizes(32 * Kilobyte, 256 * Kilobyte, 2048 * Kilobyte);
}

} // namespace

int main(int count, char** words) {
    fixBlocksOfProducts();
    const std::vector<std::string> arguments(words + 1, words + count);
    if (halbench::app::isWindowCall(arguments)) {
        return halbench::app::runWindow(arguments);
    }
    return halbench::app::runProgram(arguments, halbench::app::catchSignals());
}
