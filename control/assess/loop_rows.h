#pragma once

namespace halbench::control {

/// The period is so many milliseconds, as what was recorded in rows of 1 ms needs it.
bool isWholeMilliseconds(double period_s);

/// The instants of a trace: whole milliseconds where the loop's period is some, else that period in the
/// fewest equal parts of at most 1 ms. Either way the loop computes at a row, every `perPeriod()`-th, and
/// nowhere else, at exactly its own period. Precondition: period_s > 0.
class LoopRows {
public:
    explicit LoopRows(double period_s);

    long perPeriod() const { return m_perPeriod; }
    double interval_s() const { return m_interval_s; }
    double time_s(long row) const;

private:
    double m_period_s = 0.0;
    double m_interval_s = 0.0;
    long m_perPeriod = 1;
    bool m_isMilliseconds = true;
};

} // namespace halbench::control
