#pragma once

#include <QString>

#include <vector>

namespace halbench::widgets {

/// A stretch of an axis, in the unit shown.
struct ValueRange {
    double low = 0.0;
    double high = 1.0;

    double length() const { return high - low; }
    bool contains(const ValueRange& other) const { return low <= other.low && other.high <= high; }
    bool operator==(const ValueRange&) const = default;
};

/// The smallest 1, 2 or 5 times a power of ten with which `length` has at most `count` steps. Needs length >
/// 0.
double niceStep(double length, int count);

/// Multiples of the step inside a range.
std::vector<double> ticksOf(const ValueRange& range, double step);

/// Decimals that ticks of this distance need; 0 for steps of one and more.
int decimalsOf(double step);

/// A tick's text in the given number of decimals and the screen's locale; never "-0.0". Values too large or
/// too small for that are written with an exponent.
QString tickText(double value, int decimals);

/// An axis that follows its data without jumping: it grows at once to whole steps around the data and shrinks
/// only after the data have needed clearly less for a while.
class AutoRange {
public:
    /// `smallestLength`: data flatter than this are not magnified further, so that the last digit's flicker
    /// does not fill the screen.
    explicit AutoRange(double smallestLength) : m_smallestLength(smallestLength) {}
    void setSmallestLength(double smallestLength) { m_smallestLength = smallestLength; }

    /// One frame with the data's extremes; without data nothing changes.
    void update(const ValueRange& data);
    /// Fits the data now, also inwards.
    void fit(const ValueRange& data);
    const ValueRange& range() const { return m_range; }

private:
    ValueRange around(const ValueRange& data) const;

    double m_smallestLength;
    ValueRange m_range{};
    ValueRange m_recent{}; ///< of the data since they began to need less
    int m_calmFrames = 0;
    bool m_hasData = false;
};

} // namespace halbench::widgets
