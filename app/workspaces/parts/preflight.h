#pragma once

#include "app/workbench/workbench.h"

#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace halbench::app {

/// State of session and board that decides whether a procedure may move the rotor.
struct PreflightFacts {
    SessionState state = SessionState::Disconnected;
    devices::DeviceState board;
    bool isJustReleased = false; ///< the stop, so lately that a second click may mean the release
    bool isMotorKnown = true;    ///< the device has a profile with procedures
    bool isDriven = true;        ///< it can be armed; else nothing warms up or moves by itself
    bool isBusy = false;         ///< a procedure runs
    QString running;             ///< what runs, when it is that of this list itself; empty otherwise
    bool isSimulated = false;
    bool hasSeveralAxes = false;
    bool hasConsent = false;                 ///< the user says that the rotor is free to turn
    std::optional<double> temperature_degC;  ///< warmest coil
    std::optional<double> forecast_degC;     ///< warmest during the run, where it can be said
    std::optional<double> coldForecast_degC; ///< the same after the coils have cooled down
    double refuse_degC = 70.0;
};

struct PreflightItem {
    bool isPassed = false;
    QString text;
    QString remedy;         ///< what to do when it is not passed
    bool isRunning = false; ///< nothing is wrong: what the list is for goes on

    bool operator==(const PreflightItem&) const = default;
};

/// One line each: device, faults, temperature, free motion. The procedure checks again itself.
std::vector<PreflightItem> preflightItems(const PreflightFacts& facts);

/// The checks in words, kept up to date, and the consent that only a real device asks for.
class Preflight : public QWidget {
    Q_OBJECT
public:
    explicit Preflight(Workbench& bench, QWidget* parent = nullptr);

    /// Warmest coil of the run if it starts at that temperature.
    void setForecast(std::function<double(double start_degC)> forecast);
    /// While the procedure of this list runs, what to say of it; empty when it has ended.
    void setRunning(const QString& words);
    std::optional<double> temperature_degC() const { return m_temperature_degC; }
    bool isPassed() const { return m_isPassed; }
    /// The first remedy that is needed; empty when all is well.
    const QString& remedy() const { return m_remedy; }

Q_SIGNALS:
    void changed(); ///< of what is passed, or of the temperature

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void show(const std::vector<PreflightItem>& items);
    void readTemperature();
    PreflightFacts facts() const;

    Workbench& m_bench;
    std::function<double(double)> m_forecast;
    std::optional<double> m_temperature_degC;
    bool m_isPassed = false;
    bool m_isReading = false;
    QString m_remedy;
    std::vector<PreflightItem> m_shown; ///< empty: the words are out of date
    QString m_running;
    QTimer m_clock; ///< temperatures age
    QGridLayout* m_grid = nullptr;
    struct Row {
        QLabel* symbol;
        QLabel* words;
    };
    std::vector<Row> m_rows;
    QCheckBox* m_consent = nullptr;
};

} // namespace halbench::app
