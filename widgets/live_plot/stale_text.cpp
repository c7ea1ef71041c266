#include "widgets/live_plot/stale_text.h"

#include "widgets/language/display_units.h"

#include <QCoreApplication>

namespace halbench::widgets {

namespace {

constexpr double StaleAfter_s = 1.0; ///< so much older than the newest of all signals

} // namespace

QString staleWords(const control::SampleHistory& history, const std::string& signal, const QString& all) {
    const auto range = history.range();
    const auto latest = history.latest(signal);
    if (!range || !latest) {
        return {};
    }
    if (latest->time_s < range->end_s - StaleAfter_s) {
        return QCoreApplication::translate("halbench::widgets::StaleWords",
                                           "No new value since %1 s on the time axis")
            .arg(fixedText(latest->time_s, 1));
    }
    return all;
}

} // namespace halbench::widgets
