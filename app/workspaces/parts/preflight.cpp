#include "app/workspaces/parts/preflight.h"

#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPointer>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

constexpr int Refresh_ms = 2000;
constexpr double Cold_degC = 25.0; ///< where a run begins that waited long enough

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::PreflightWords)
};

QString degrees(double temperature_degC) {
    return widgets::fixedText(temperature_degC, 0) + QStringLiteral(" \u00b0C");
}

PreflightItem deviceItem(const PreflightFacts& facts) {
    if (facts.state == SessionState::Reconnecting) {
        return {false, Words::tr("Connection lost, reconnecting"), Words::tr("Plug it in or switch it on")};
    }
    if (facts.state != SessionState::Connected) {
        return {false, Words::tr("No device is connected"), Words::tr("Connect one in the Devices panel")};
    }
    if (!facts.isMotorKnown) {
        return {false, Words::tr("No profile for the motor of this device"),
                Words::tr("Use it by signal and parameter name in Signals, Record and Parameters")};
    }
    if (!facts.running.isEmpty()) {
        return {false, facts.running, Words::tr("Wait until it ends, or cancel it"), true};
    }
    if (facts.isBusy) {
        return {false, Words::tr("Another procedure is running"),
                Words::tr("Wait until it ends, or cancel it")};
    }
    return {true, Words::tr("Device connected and idle"), {}};
}

PreflightItem faultItem(const PreflightFacts& facts) {
    if (facts.board.fault != 0) {
        return {false, Words::tr("Fault: %1").arg(widgets::inWords(facts.board.faultText)),
                Words::tr("Remove the cause, then release the stop in the Drive panel")};
    }
    if (facts.board.isStopLatched) {
        return {false, Words::tr("The stop is latched"),
                Words::tr("Press Release next to the state at the top")};
    }
    if (facts.isJustReleased) {
        return {false, Words::tr("The stop was released just now"), Words::tr("Check, then start")};
    }
    if (facts.isBusy) {
        return {true, Words::tr("No fault, not stopped"), {}}; // armed or not is the procedure's
    }
    if (facts.board.isArmed) {
        return {false, Words::tr("The device is armed manually"), Words::tr("Disarm it first")};
    }
    return {true, Words::tr("No fault, not stopped, not armed"), {}};
}

PreflightItem temperatureItem(const PreflightFacts& facts) {
    if (!facts.temperature_degC) {
        return {true, Words::tr("Coil temperature unknown; it is measured first"), {}};
    }
    const QString now = Words::tr("Coils %1 now").arg(degrees(*facts.temperature_degC));
    const double warmest_degC = facts.forecast_degC.value_or(*facts.temperature_degC);
    const QString both =
        facts.forecast_degC ? Words::tr("%1, up to %2 expected").arg(now, degrees(warmest_degC)) : now;
    if (warmest_degC < facts.refuse_degC) {
        return {true, both, {}};
    }
    if (facts.coldForecast_degC.value_or(warmest_degC) < facts.refuse_degC) {
        // Procedures wait before each part that would become too warm.
        return {true, Words::tr("%1; the run pauses near %2").arg(now, degrees(facts.refuse_degC)), {}};
    }
    return {false, both,
            Words::tr("Use less current or fewer steps to stay below %1").arg(degrees(facts.refuse_degC))};
}

PreflightItem motionItem(const PreflightFacts& facts) {
    if (facts.isSimulated) {
        return {true, Words::tr("Simulated: no collision possible"), {}};
    }
    return {facts.hasConsent,
            facts.hasSeveralAxes ? Words::tr("Every axis is free to move and clear of people")
                                 : Words::tr("Rotor is free to turn and clear of people"),
            Words::tr("Check, then confirm below")};
}

QIcon iconOf(const PreflightItem& item) {
    return item.isPassed    ? widgets::themedIcon(QStringLiteral("ok"), widgets::Role::Good)
           : item.isRunning ? widgets::themedIcon(QStringLiteral("info"), widgets::Role::Primary)
                            : widgets::themedIcon(QStringLiteral("warning"), widgets::Role::Warn);
}

} // namespace

std::vector<PreflightItem> preflightItems(const PreflightFacts& facts) {
    std::vector<PreflightItem> items = {deviceItem(facts)};
    if (facts.state == SessionState::Connected && facts.isMotorKnown) {
        items.push_back(faultItem(facts));
        if (facts.isDriven) {
            items.push_back(temperatureItem(facts));
            items.push_back(motionItem(facts));
        }
    }
    return items;
}

Preflight::Preflight(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_grid(new QGridLayout(this)), m_consent(new QCheckBox(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(widgets::PanelMargin_px);
    m_grid->setVerticalSpacing(widgets::GridStep_px);
    m_grid->setColumnStretch(1, 1);
    constexpr int MostRows = 4;
    for (int i = 0; i < MostRows; ++i) {
        Row row{new QLabel(this), new QLabel(this)};
        row.words->setWordWrap(true);
        m_grid->addWidget(row.symbol, i, 0, Qt::AlignTop);
        m_grid->addWidget(row.words, i, 1);
        m_rows.push_back(row);
    }
    m_grid->addWidget(m_consent, MostRows, 0, 1, 2);
    m_clock.setInterval(Refresh_ms);
    connect(&m_clock, &QTimer::timeout, this, &Preflight::readTemperature);
    connect(m_consent, &QCheckBox::toggled, this, &Preflight::refresh);
    connect(&m_bench, &Workbench::deviceChanged, this, [this] {
        m_consent->setChecked(false); // consent is for one device
        m_temperature_degC.reset();
        refresh();
        readTemperature();
    });
    DeviceSession& session = m_bench.session();
    connect(&session, &DeviceSession::reportChanged, this, &Preflight::refresh);
    connect(&m_bench.stopLatch(), &StopLatch::changed, this, &Preflight::refresh);
    connect(&session, &DeviceSession::procedureChanged, this, [this] {
        refresh();
        readTemperature();
    });
    refresh();
    readTemperature();
}

void Preflight::setForecast(std::function<double(double)> forecast) {
    m_forecast = std::move(forecast);
    refresh();
}

void Preflight::setRunning(const QString& words) {
    m_running = words;
    refresh();
}

PreflightFacts Preflight::facts() const {
    const DeviceSession& session = m_bench.session();
    PreflightFacts facts;
    facts.state = session.state();
    facts.board = session.report().board;
    facts.isJustReleased = m_bench.stopLatch().isJustReleased();
    facts.isMotorKnown =
        session.catalogue().hasProcedure("identify") || session.catalogue().hasProcedure("calibrate");
    facts.isDriven = session.catalogue().findParameter("hb.arm") != nullptr;
    facts.isBusy = !session.procedure().isEmpty();
    facts.running = facts.isBusy ? m_running : QString();
    facts.isSimulated = session.info().isSimulated;
    facts.hasSeveralAxes = session.catalogue().axes.size() > 1;
    facts.hasConsent = m_consent->isChecked();
    facts.temperature_degC = m_temperature_degC;
    if (m_temperature_degC && m_forecast) {
        facts.forecast_degC = m_forecast(*m_temperature_degC);
        facts.coldForecast_degC = m_forecast(Cold_degC);
    }
    return facts;
}

/// The device reports ten times a second; most of the time nothing is new.
void Preflight::refresh() {
    const PreflightFacts now = facts();
    const std::vector<PreflightItem> items = preflightItems(now);
    m_consent->setVisible(now.state == SessionState::Connected && !now.isSimulated && now.isMotorKnown &&
                          now.isDriven);
    m_consent->setText(now.hasSeveralAxes ? tr("The axes may move now") : tr("The rotor may turn now"));
    m_consent->setToolTip(now.hasSeveralAxes ? tr("A real actuator moves only after your confirmation")
                                             : tr("A real motor moves only after your confirmation"));
    if (items != m_shown) {
        m_shown = items;
        show(items);
    }
}

void Preflight::show(const std::vector<PreflightItem>& items) {
    const QString remedyBefore = std::exchange(m_remedy, QString());
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const bool isThere = i < items.size();
        m_rows[i].symbol->setVisible(isThere);
        m_rows[i].words->setVisible(isThere);
        if (!isThere) {
            continue;
        }
        const PreflightItem& item = items[i];
        m_rows[i].symbol->setPixmap(iconOf(item).pixmap(16, 16));
        m_rows[i].words->setText(item.isPassed ? item.text
                                               : item.text + QStringLiteral(" \u2192 ") + item.remedy);
        m_remedy = m_remedy.isEmpty() && !item.isPassed ? item.remedy : m_remedy;
    }
    m_isPassed = m_remedy.isEmpty();
    setAccessibleName(tr("Checks before the start"));
    if (m_remedy != remedyBefore) {
        Q_EMIT changed();
    }
}

void Preflight::readTemperature() {
    DeviceSession& session = m_bench.session();
    if (m_isReading || session.state() != SessionState::Connected || !session.procedure().isEmpty()) {
        return;
    }
    std::vector<std::string> names;
    for (const SignalSpec& spec : session.catalogue().signals) {
        if (spec.role.starts_with("coil_temperature.")) {
            names.push_back(spec.name);
        }
    }
    if (names.empty()) {
        return;
    }
    m_isReading = true;
    const QPointer<Preflight> self(this);
    session.request([names](devices::Device& device) { return device.readSignals(names); },
                    [self](const Result<std::vector<double>>& values) {
                        if (!self) {
                            return;
                        }
                        self->m_isReading = false;
                        if (values && !values->empty()) {
                            self->m_temperature_degC = *std::max_element(values->begin(), values->end());
                            Q_EMIT self->changed();
                        }
                        self->refresh();
                    });
}

void Preflight::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    readTemperature();
    m_clock.start();
}

void Preflight::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_clock.stop();
}

void Preflight::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
        m_shown.clear();
        refresh();
    }
}

} // namespace halbench::app
