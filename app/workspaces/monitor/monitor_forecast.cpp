#include "app/workspaces/monitor/monitor_forecast.h"

#include "app/workbench/display_quantity.h"
#include "app/workspaces/monitor/monitor_plots.h"
#include "widgets/controls/elided_label.h"
#include "widgets/language/display_units.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/theme/theme_style.h"

#include <algorithm>

namespace halbench::app {

namespace {

using Forecast = control::LimitForecast;
constexpr int Period_ms = 1000;
constexpr int LeastCharacters = 24;
constexpr int LongestSilence = 3; ///< looks
constexpr double Soon_s = 600.0;  ///< from here on it warns
constexpr double VerySoon_s = 60.0;

QString withheldWords(const Forecast& forecast) {
    switch (forecast.reason) {
    case Forecast::Reason::TooShort:
        return MonitorForecast::tr("needs %2 s of steady load (%1 s so far)")
            .arg(widgets::fixedText(forecast.stretch_s, 0), widgets::fixedText(Forecast::LeastStretch_s, 0));
    case Forecast::Reason::NoStep:
        return MonitorForecast::tr("temperature change below the sensor's resolution");
    case Forecast::Reason::NotFirstOrder:
        return MonitorForecast::tr("temperature does not follow a steady load");
    case Forecast::Reason::None:
        break;
    }
    return {};
}

widgets::Role roleOf(const Forecast& forecast) {
    const bool isDated = forecast.verdict == Forecast::Verdict::Reached;
    if (forecast.verdict == Forecast::Verdict::AtLimit || (isDated && *forecast.earliest_s < VerySoon_s)) {
        return widgets::Role::Bad;
    }
    return isDated && *forecast.earliest_s < Soon_s ? widgets::Role::Warn : widgets::Role::Muted;
}

} // namespace

QString spanWords(double time_s) {
    constexpr double Minute_s = 60.0;
    constexpr double Hour_s = 3600.0;
    if (time_s < 2.0 * Minute_s) {
        return MonitorForecast::tr("%1 s").arg(widgets::fixedText(time_s, 0));
    }
    return time_s < 2.0 * Hour_s ? MonitorForecast::tr("%1 min").arg(widgets::fixedText(time_s / Minute_s, 1))
                                 : MonitorForecast::tr("%1 h").arg(widgets::fixedText(time_s / Hour_s, 1));
}

QString forecastWords(const CoilForecast& coil) {
    const Forecast& forecast = coil.forecast;
    const QString name = signalWords(coil.signal);
    const QString limit = MonitorForecast::tr("%1 °C").arg(widgets::fixedText(forecast.limit_degC, 0));
    switch (forecast.verdict) {
    case Forecast::Verdict::Reached:
        return MonitorForecast::tr("%1 reaches %2 at this load in %3 (95 %: %4 to %5).")
            .arg(name, limit, spanWords(*forecast.time_s), spanWords(forecast.interval95_s->first),
                 spanWords(forecast.interval95_s->second));
    case Forecast::Verdict::NotReached:
        return forecast.final95_degC
                   ? MonitorForecast::tr("%1 stays below %2 at this load: final value %3 to %4 °C.")
                         .arg(name, limit, widgets::fixedText(forecast.final95_degC->first, 1),
                              widgets::fixedText(forecast.final95_degC->second, 1))
                   : MonitorForecast::tr("%1 stays below %2 at this load.").arg(name, limit);
    case Forecast::Verdict::NotBefore:
        return MonitorForecast::tr("%1 stays below %2 for %3 at this load; final value not known yet.")
            .arg(name, limit, spanWords(*forecast.earliest_s));
    case Forecast::Verdict::AtLimit:
        return MonitorForecast::tr("%1 is at its limit of %2.").arg(name, limit);
    case Forecast::Verdict::Withheld:
        break;
    }
    return MonitorForecast::tr("Time to %1: %2.").arg(limit, withheldWords(forecast));
}

MonitorForecast::MonitorForecast(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_stack(stack) {
    m_words = new widgets::ElidedLabel(LeastCharacters, &panel);
    m_words->setAccessibleName(tr("Time until the coil limit is reached"));
    m_words->setContentsMargins(widgets::PanelMargin_px, widgets::GridStep_px / 2, widgets::PanelMargin_px,
                                widgets::GridStep_px / 2);
    widgets::setRole(*m_words, widgets::Role::Muted);
    m_words->hide();
    connect(&m_bench, &Workbench::deviceChanged, this, &MonitorForecast::forget);
    connect(&m_stack, &widgets::LivePlotStack::plotsChanged, this, &MonitorForecast::refresh);
    connect(&m_timer, &QTimer::timeout, this, &MonitorForecast::take);
    m_timer.start(Period_ms);
}

QWidget& MonitorForecast::row() {
    return *m_words;
}

void MonitorForecast::forget() {
    m_watch.reset();
    if (m_bench.session().state() == SessionState::Connected) {
        m_watch.emplace(m_bench.catalogue());
        const auto range = m_bench.history().range();
        m_taken_s = range ? range->end_s : 0.0;
    }
    refresh();
}

/// What came since the last look; what is older than the oldest that can matter is not looked at.
void MonitorForecast::take() {
    if (m_bench.session().state() != SessionState::Connected) {
        refresh();
        return;
    }
    const control::SampleHistory& history = m_bench.history();
    const auto range = history.range();
    if (!m_watch || !range || range->end_s < m_taken_s) {
        m_watch.emplace(m_bench.catalogue());
        m_taken_s = range ? range->end_s : 0.0;
    }
    bool hasComeOn = false;
    if (range && range->end_s > m_taken_s) {
        constexpr double LongestLook_s = 120.0; // of a second at the highest pace; not all of a recording
        const double begin_s = std::max(m_taken_s, range->end_s - LongestLook_s);
        for (std::size_t coil = 0; coil < m_watch->coils().size(); ++coil) {
            hasComeOn = takeCoil(coil, {begin_s, range->end_s}) || hasComeOn;
        }
        m_taken_s = range->end_s;
    }
    m_silence = hasComeOn ? 0 : m_silence + 1;
    if (m_silence >= LongestSilence) {
        m_watch.emplace(m_bench.catalogue()); // what was then says nothing of now
    }
    refresh();
}

/// Whether there was a temperature.
bool MonitorForecast::takeCoil(std::size_t coil, control::TimeRange range) {
    const control::SampleHistory& history = m_bench.history();
    const CoilTemperatureMonitor::Coil& names = m_watch->coils()[coil];
    std::vector<control::TimedValue> temperatures;
    std::vector<control::TimedValue> currents;
    if (names.temperature.empty() || !history.samples(names.temperature, range, temperatures)) {
        return false;
    }
    if (!names.current.empty()) {
        (void)history.samples(names.current, range, currents);
    }
    const auto isOutside = [range](const control::TimedValue& sample) {
        return sample.time_s <= range.begin_s || sample.time_s > range.end_s;
    };
    temperatures.erase(std::remove_if(temperatures.begin(), temperatures.end(), isOutside),
                       temperatures.end());
    m_watch->add(coil, temperatures, currents);
    return !temperatures.empty();
}

bool MonitorForecast::isShown() const {
    if (!m_watch || m_bench.session().state() != SessionState::Connected) {
        return false;
    }
    const std::set<std::string> plotted = plottedSignals(m_stack.plots());
    return std::any_of(
        m_watch->coils().begin(), m_watch->coils().end(),
        [&](const CoilTemperatureMonitor::Coil& coil) { return plotted.count(coil.temperature) > 0; });
}

std::optional<double> MonitorForecast::limit_degC() const {
    const devices::Catalogue& catalogue = m_bench.catalogue();
    return temperatureBands(catalogue, m_bench.deviceValue(catalogue.parameterForRole("limit.temperature")))
        .bad_degC;
}

void MonitorForecast::refresh() {
    const std::optional<double> limit = isShown() ? limit_degC() : std::nullopt;
    const std::vector<CoilForecast> forecasts =
        limit ? m_watch->tellingForecasts(*limit) : std::vector<CoilForecast>();
    const CoilForecast* first = mostUrgent(forecasts);
    m_words->setVisible(first != nullptr);
    if (first == nullptr) {
        return;
    }
    m_words->setWords(forecastWords(*first));
    QStringList all;
    for (const CoilForecast& forecast : forecasts) {
        all.append(forecastWords(forecast));
    }
    m_words->setToolTip(all.join(QLatin1Char('\n')));
    widgets::setRole(*m_words, roleOf(first->forecast));
}

} // namespace halbench::app
