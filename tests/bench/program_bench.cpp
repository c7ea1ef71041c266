// What the user waits for at the command line.
#include "tests/bench/goal.h"

#include <cstdlib>
#include <string>

namespace halbench::bench {
namespace {

int run(const std::string& arguments) {
    return std::system((std::string(HALBENCH_PROGRAM) + " " + arguments + " >/dev/null 2>&1").c_str());
}

void benchCommand(Goals& goals, const std::string& name, const std::string& arguments, double goal_s,
                  int rounds) {
    if (const int status = run(arguments); status != 0) {
        return goals.failed(name, "halbench " + arguments + " failed with status " + std::to_string(status));
    }
    goals.below(name, wallTime_s([&] { (void)run(arguments); }, rounds), goal_s, "s");
}

} // namespace
} // namespace halbench::bench

int main() {
    halbench::bench::Goals goals;
    halbench::bench::benchCommand(goals, "halbench --version", "--version", 0.05, 20);
    halbench::bench::benchCommand(goals, "sweep of 13 currents in both directions",
                                  "identify sim:htm --given J=5.5e-4 --currents 1.6:4.0:0.2", 3.0, 3);
    return goals.exitCode();
}
