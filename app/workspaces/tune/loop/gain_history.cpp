#include "app/workspaces/tune/loop/gain_history.h"

#include "control/base/assert.h"

#include <utility>

namespace halbench::app {

namespace {

/// A hand can do more than this in a day; nobody goes back as far.
constexpr std::size_t MostSteps = 500;

} // namespace

bool GainChoice::isSameAs(const GainChoice& other) const {
    return origin == other.origin && law == other.law && targets == other.targets &&
           restored.has_value() == other.restored.has_value();
}

void GainHistory::restart(GainChoice now) {
    m_now = std::move(now);
    m_steps.clear();
    m_done = 0;
}

void GainHistory::record(const QString& what, const QString& key, GainChoice now) {
    if (now.isSameAs(m_now)) {
        return;
    }
    m_steps.resize(m_done);
    if (m_done > 0 && !key.isEmpty() && m_steps.back().key == key) {
        m_steps.back().after = now;
    } else {
        m_steps.push_back({what, key, m_now, now});
    }
    if (m_steps.size() > MostSteps) {
        m_steps.erase(m_steps.begin());
    }
    m_done = m_steps.size();
    m_now = std::move(now);
}

const GainChoice& GainHistory::undo() {
    HB_ASSERT(canUndo());
    --m_done;
    m_steps[m_done].key.clear(); // what is done from here is a step of its own
    if (m_done > 0) {
        m_steps[m_done - 1].key.clear();
    }
    return m_now = m_steps[m_done].before;
}

const GainChoice& GainHistory::redo() {
    HB_ASSERT(canRedo());
    return m_now = m_steps[m_done++].after;
}

} // namespace halbench::app
