#include "tests/bench/goal.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <limits>

namespace halbench::bench {

double processorTime_s(const std::function<void()>& work, int rounds) {
    double least_s = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds; ++i) {
        const std::clock_t start = std::clock();
        work();
        least_s = std::min(least_s, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least_s;
}

double wallTime_s(const std::function<void()>& work, int rounds) {
    double least_s = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        least_s = std::min(least_s,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return least_s;
}

void Goals::atLeast(const std::string& name, double value, double goal, const std::string& unit) {
    print(name, value, "at least", goal, unit, value >= goal);
}

void Goals::below(const std::string& name, double value, double goal, const std::string& unit) {
    print(name, value, "below", goal, unit, value < goal);
}

void Goals::failed(const std::string& name, const std::string& cause) {
    fmt::print("{}: not measured ({}): MISSED\n", name, cause);
    m_isMissed = true;
}

void Goals::print(const std::string& name, double value, const char* relation, double goal,
                  const std::string& unit, bool isMet) {
    fmt::print("{}: {:.3g} {}, {} {:.3g}: {}\n", name, value, unit, relation, goal, isMet ? "met" : "MISSED");
    std::fflush(stdout);
    m_isMissed = m_isMissed || !isMet;
}

} // namespace halbench::bench
