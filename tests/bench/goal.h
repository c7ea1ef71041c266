#pragma once

#include <functional>
#include <string>

namespace halbench::bench {

/// Seconds of processor time of this process that one call takes: the least of several rounds, because other
/// work on the machine only ever adds.
double processorTime_s(const std::function<void()>& work, int rounds);

/// Seconds on the wall clock, likewise.
double wallTime_s(const std::function<void()>& work, int rounds);

/// Collects the goals of one program and prints a line for each.
class Goals {
public:
    /// "name: value unit, at least goal: met"
    void atLeast(const std::string& name, double value, double goal, const std::string& unit);
    void below(const std::string& name, double value, double goal, const std::string& unit);
    /// A goal that could not even be measured is missed.
    void failed(const std::string& name, const std::string& cause);
    /// 0 when all were met, else 1.
    int exitCode() const { return m_isMissed ? 1 : 0; }

private:
    void print(const std::string& name, double value, const char* relation, double goal,
               const std::string& unit, bool isMet);
    bool m_isMissed = false;
};

} // namespace halbench::bench
