#include "app/workspaces/actuators/spherical/angle_error_panel.h"

#include "app/workbench/signals/last_rows.h"
#include "app/workspaces/actuators/spherical/board_sensors.h"
#include "app/workspaces/parts/field_grid.h"
#include "control/base/units.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int GridColumns = 4;
constexpr int Period_ms = 250;
constexpr std::size_t MostRows = std::size_t{1} << 15; ///< half a minute at a thousand a second
constexpr std::size_t DrawnPoints = 1200;
constexpr int PictureHeight_px = 360;

std::vector<double> degreesOf(const std::vector<double>& angles_rad) {
    std::vector<double> angles_deg;
    std::transform(angles_rad.begin(), angles_rad.end(), std::back_inserter(angles_deg), radiansToDegrees);
    return angles_deg;
}

QString significantText(double angle_deg) {
    return widgets::numberText(angle_deg, 3);
}

} // namespace

AngleErrorPanel::AngleErrorPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* column = makePanelColumn(this);
    auto* grid = new FieldGrid(GridColumns, this);
    m_span = grid->addNumber(
        {tr("Time span"), tr("Length of the data shown, up to now"), QStringLiteral("s"), 1, 0.1, 30.0, 1.0});
    m_span->setQuantity(10.0);
    column->addWidget(grid);
    m_view = new widgets::FigureView(this);
    m_view->setToolTip(tr("Arrow keys read values; Ctrl+C copies, Ctrl+E saves"));
    column->addWidget(m_view, 1);
    m_words = makeNote(this);
    m_words->setAccessibleName(tr("Summary of the angle error"));
    reserveLines(*m_words, 2);
    column->addWidget(m_words);
    connect(m_view, &widgets::FigureView::exportRequested, this, [this] {
        savePicture(this, m_chooser, QStringLiteral("angle-error.svg"), m_files, m_view->taken(),
                    [this](const Error& error) {
                        m_words->setText(widgets::inWords(error.message) + QStringLiteral(": ") +
                                         widgets::inWords(error.hint));
                    });
    });
    connect(m_span, &widgets::QuantityEdit::edited, this, &AngleErrorPanel::askAnew);
    connect(&m_bench, &Workbench::deviceChanged, this, &AngleErrorPanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this, &AngleErrorPanel::want);
    connect(&m_timer, &QTimer::timeout, this, &AngleErrorPanel::ask);
    m_timer.start(Period_ms);
    onDevice();
}

bool AngleErrorPanel::hasDevice() const {
    return m_bench.hasValues() && isMadeFor(angleErrorActuatorPanel(), m_bench.session().catalogue());
}

std::vector<std::string> AngleErrorPanel::signalNames() const {
    std::vector<std::string> names;
    for (const std::string& role : angleErrorRoles()) {
        names.push_back(signalOfRole(m_bench.session().catalogue(), role));
    }
    return names;
}

void AngleErrorPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    want();
}

void AngleErrorPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

/// Streamed only while somebody looks.
void AngleErrorPanel::want() {
    m_bench.liveSignals().want(this, isVisible() && hasDevice() ? signalNames() : std::vector<std::string>());
}

void AngleErrorPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected || session.returns() == 0) {
        m_task.cancel();
        m_view->clear();
        m_words->setText(tr("Shows the angle between the estimated and the true orientation of a simulated "
                            "rotor. Connect a simulated device that measures its field, or play a recording "
                            "with truth.alpha, truth.beta and truth.gamma."));
    }
    want();
    askAnew();
}

void AngleErrorPanel::askAnew() {
    m_seen.reset();
    ask();
}

void AngleErrorPanel::ask() {
    const std::uint64_t revision = m_bench.history().revision();
    if (!isVisible() || !hasDevice() || m_task.isBusy() || m_seen == revision) {
        return;
    }
    m_seen = revision;
    m_task.run([rows = lastRows(m_bench.history(), signalNames(), m_span->value(),
                                MostRows)] { return angleErrors(rows, DrawnPoints); },
               [this](const AngleErrors& errors) { take(errors); });
}

void AngleErrorPanel::take(const AngleErrors& errors) {
    if (errors.rows == 0 || !hasDevice()) {
        return;
    }
    widgets::Figure figure;
    figure.title = tr("Angle between the estimated and the true orientation").toStdString();
    figure.x = {tr("time").toStdString(), "s", false, {}, {}, {}};
    widgets::Panel panel;
    panel.y = {tr("angle error").toStdString(), "°", false, 0.0, {}, {}};
    panel.height_px = PictureHeight_px;
    panel.curves.push_back({tr("orientation").toStdString(),
                            errors.time_s,
                            degreesOf(errors.rotation_rad),
                            widgets::CurveStyle::Line,
                            {}});
    panel.curves.push_back({tr("shaft").toStdString(),
                            errors.time_s,
                            degreesOf(errors.shaft_rad),
                            widgets::CurveStyle::Line,
                            {}});
    panel.curves.push_back({tr("95 % cone of the shaft").toStdString(),
                            errors.time_s,
                            degreesOf(errors.cone_rad),
                            widgets::CurveStyle::DashedLine,
                            {}});
    figure.panels.push_back(std::move(panel));
    m_view->setFigure(std::move(figure));
    m_words->setText(
        tr("%1 rows: %2° rms, %3° at most, to the nearest of the four orientations with the same field.")
            .arg(widgets::countText(errors.rows), significantText(radiansToDegrees(errors.rms_rad)),
                 significantText(radiansToDegrees(errors.worst_rad))));
}

ActuatorPanel angleErrorActuatorPanel() {
    return {"angle_error",
            QT_TRANSLATE_NOOP("Panels", "Angle error"),
            "monitor.md#angle-error",
            boardSensorRoles(),
            [](Workbench& bench) -> QWidget* { return new AngleErrorPanel(bench); },
            [](QWidget& panel, FileChooser chooser) {
                static_cast<AngleErrorPanel&>(panel).setFileChooser(std::move(chooser));
            },
            angleErrorRoles()};
}

} // namespace halbench::app
