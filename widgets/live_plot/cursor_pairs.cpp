#include "widgets/live_plot/cursor_pairs.h"

#include <algorithm>
#include <utility>

namespace halbench::widgets {
namespace {

const QString FirstName = QStringLiteral("1");

} // namespace

CursorPairs::CursorPairs(std::vector<NamedPair> pairs, std::size_t chosen) {
    for (NamedPair& pair : pairs) {
        pair.name = pair.name.trimmed();
        if (pair.name.isEmpty() || isTaken(pair.name)) {
            pair.name = freeNumber();
        }
        m_pairs.push_back(std::move(pair));
    }
    if (m_pairs.empty()) {
        m_pairs.push_back({FirstName});
    }
    m_chosen = std::min(chosen, m_pairs.size() - 1);
}

CursorPair CursorPairs::cursors() const {
    return {m_pairs[m_chosen].a_s, m_pairs[m_chosen].b_s, m_isVisible, m_active};
}

bool CursorPairs::areKept() const {
    return m_pairs.size() > 1 || name() != FirstName;
}

void CursorPairs::move(int index, double time_s) {
    (index == 0 ? m_pairs[m_chosen].a_s : m_pairs[m_chosen].b_s) = time_s;
    m_active = index;
}

void CursorPairs::add(double a_s, double b_s) {
    m_pairs.push_back({freeNumber(), a_s, b_s});
    m_chosen = m_pairs.size() - 1;
}

void CursorPairs::choose(std::size_t pair) {
    m_chosen = std::min(pair, m_pairs.size() - 1);
}

void CursorPairs::chooseNext(int by) {
    const auto count = static_cast<int>(m_pairs.size());
    m_chosen = static_cast<std::size_t>(((static_cast<int>(m_chosen) + by) % count + count) % count);
}

bool CursorPairs::rename(const QString& name) {
    const QString wanted = name.trimmed();
    if (wanted == this->name()) {
        return true;
    }
    if (wanted.isEmpty() || isTaken(wanted)) {
        return false;
    }
    m_pairs[m_chosen].name = wanted;
    return true;
}

void CursorPairs::remove() {
    if (m_pairs.size() == 1) {
        m_pairs.front().name = FirstName;
        return;
    }
    m_pairs.erase(m_pairs.begin() + static_cast<std::ptrdiff_t>(m_chosen));
    m_chosen = std::min(m_chosen, m_pairs.size() - 1);
}

QString CursorPairs::freeNumber() const {
    for (int number = 1;; ++number) {
        if (const QString name = QString::number(number); !isTaken(name)) {
            return name;
        }
    }
}

bool CursorPairs::isTaken(const QString& name) const {
    return std::any_of(m_pairs.begin(), m_pairs.end(),
                       [&](const NamedPair& pair) { return pair.name == name; });
}

} // namespace halbench::widgets
