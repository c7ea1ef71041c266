#pragma once

#include <QString>

#include <cstddef>
#include <vector>

namespace halbench::widgets {

/// Where two cursors are; the keyboard moves the active one.
struct CursorPair {
    double a_s = 0.0;
    double b_s = 0.0;
    bool isVisible = false;
    int active = 0; ///< 0 = A, 1 = B

    double at(int index) const { return index == 0 ? a_s : b_s; }
    bool operator==(const CursorPair&) const = default;
};

/// Where a pair was put and what it is called.
struct NamedPair {
    QString name;
    double a_s = 0.0;
    double b_s = 0.0;

    double at(int index) const { return index == 0 ? a_s : b_s; }
    bool operator==(const NamedPair&) const = default;
};

/// Pairs of cursors, one of which measures; the others are landmarks. There is always one. Names are neither
/// empty nor equal; a pair that the user did not name is called by the first number that is free. A value.
class CursorPairs {
public:
    CursorPairs() : CursorPairs({}, 0) {}
    /// As they were kept: a name that is empty or used already becomes a number, no pairs become one.
    CursorPairs(std::vector<NamedPair> pairs, std::size_t chosen);

    const std::vector<NamedPair>& list() const { return m_pairs; }
    std::size_t chosen() const { return m_chosen; }
    const QString& name() const { return m_pairs[m_chosen].name; }
    /// The one that measures.
    CursorPair cursors() const;
    /// Whether there is more than the one pair that nobody named: that one comes and goes with the view.
    bool areKept() const;

    void setVisible(bool areVisible) { m_isVisible = areVisible; }
    void setActive(int index) { m_active = index; }
    /// Moves a cursor of the pair that measures.
    void move(int index, double time_s);
    /// Another pair, which measures from now on.
    void add(double a_s, double b_s);
    void choose(std::size_t pair);
    /// The one `by` places on, in a circle.
    void chooseNext(int by);
    /// Of the pair that measures; false: empty, or another one's.
    bool rename(const QString& name);
    /// Takes the pair that measures away; the last one becomes the unnamed one.
    void remove();

    bool operator==(const CursorPairs&) const = default;

private:
    QString freeNumber() const;
    bool isTaken(const QString& name) const;

    std::vector<NamedPair> m_pairs;
    std::size_t m_chosen = 0;
    bool m_isVisible = false;
    int m_active = 0;
};

} // namespace halbench::widgets
