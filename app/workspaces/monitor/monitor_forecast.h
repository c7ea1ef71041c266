#pragma once

#include "app/procedures/base/coil_temperature_monitor.h"
#include "app/workbench/workbench.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace halbench::widgets {
class ElidedLabel;
class LivePlotStack;
} // namespace halbench::widgets

namespace halbench::app {

/// The line below the Monitor's plots while one of them shows a coil's temperature: when it reaches the
/// device's limit at this load (resources/help/monitor.md, "Temperature"). Thread: GUI.
class MonitorForecast : public QObject {
    Q_OBJECT

public:
    MonitorForecast(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel);

    QWidget& row();

private:
    void forget();
    void take();
    bool takeCoil(std::size_t coil, control::TimeRange range);
    void refresh();
    bool isShown() const;
    std::optional<double> limit_degC() const;

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    widgets::ElidedLabel* m_words = nullptr;
    std::optional<CoilTemperatureMonitor> m_watch;
    double m_taken_s = 0.0; ///< up to this time of the history
    int m_silence = 0;      ///< looks in a row that found no temperature
    QTimer m_timer;
};

/// "Coil A reaches 80 °C in 4 to 6 min at this load."
QString forecastWords(const CoilForecast& forecast);
/// "45 s", "4.5 min", "2.3 h"
QString spanWords(double time_s);

} // namespace halbench::app
