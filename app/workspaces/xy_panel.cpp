#include "app/workspaces/xy_panel.h"

#include "app/procedures/ellipse_shape.h"
#include "app/workspaces/document_files.h"
#include "app/workspaces/field_grid.h"
#include "app/workspaces/signal_box.h"
#include "control/base/units.h"
#include "widgets/empty_state.h"
#include "widgets/estimate_table.h"
#include "widgets/figure_view.h"
#include "widgets/phrasebook.h"
#include "widgets/quantity_edit.h"

#include <QCheckBox>
#include <QLabel>
#include <QLocale>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int Period_ms = 250;
constexpr std::size_t MostRows = std::size_t{1} << 17; ///< copied at once, about a millisecond
constexpr std::size_t DrawnPoints = 1500;              ///< the eye sees no more in such a cloud
constexpr std::size_t EllipsePoints = 180;
constexpr int GridColumns = 4;
constexpr int PictureHeight_px = 360;
constexpr double Sigmas95 = 1.959964;
constexpr double PerCent = 100.0;

/// Every so manieth, the newest last.
SignalPair thinned(const SignalPair& all, double xFactor, double yFactor) {
    const std::size_t step = std::max<std::size_t>(1, all.x.size() / DrawnPoints);
    SignalPair points;
    for (std::size_t i = (all.x.size() + step - 1) % step; i < all.x.size(); i += step) {
        points.x.push_back(xFactor * all.x[i]);
        points.y.push_back(yFactor * all.y[i]);
    }
    return points;
}

widgets::EstimateRow estimate(const QString& name, double value, double error, const QString& unit) {
    return {name, value, value - Sigmas95 * error, value + Sigmas95 * error, unit, {}, {}};
}

} // namespace

XyPanel::XyPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_pages = new QStackedWidget(this);
    auto* empty = new widgets::EmptyState(m_pages);
    empty->setIconName(QStringLiteral("connect"));
    empty->setWords(
        tr("Nothing to show yet"),
        tr("Shows two signals of a connected device against each other, at first the Hall sensors "
           "with their ellipse. Choose a device at the left, or try the simulated motor."),
        tr("Connect the simulated motor"), QStringLiteral("Ctrl+Shift+S"));
    m_pages->addWidget(empty);
    m_pages->addWidget(buildContent());
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(m_pages);
    connect(empty, &widgets::EmptyState::actionTriggered, this, &XyPanel::connectRequested);
    connect(&m_bench, &Workbench::deviceChanged, this, &XyPanel::onDevice);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &XyPanel::askAnew);
    connect(&m_timer, &QTimer::timeout, this, &XyPanel::ask);
    m_timer.start(Period_ms);
    onDevice();
}

QWidget* XyPanel::buildContent() {
    auto* content = new QWidget(m_pages);
    QVBoxLayout* column = makePanelColumn(content);
    column->addWidget(buildFields(content));
    m_view = new widgets::FigureView(content);
    m_view->setToolTip(
        tr("The arrow keys walk along the points; Ctrl+C copies the picture, Ctrl+E saves it"));
    column->addWidget(m_view, 1);
    m_words = makeNote(content);
    m_words->setAccessibleName(tr("What the ellipse says"));
    reserveLines(*m_words, 2);
    column->addWidget(m_words);
    m_numbers = new widgets::EstimateTable(content);
    m_numbers->setAccessibleName(tr("Fitted ellipse"));
    column->addWidget(m_numbers);
    connect(m_view, &widgets::FigureView::exportRequested, this, [this] {
        savePicture(this, m_chooser, QStringLiteral("xy.svg"), m_files, *m_view,
                    [this](const Error& error) { sayWarning(error); });
    });
    return content;
}

QWidget* XyPanel::buildFields(QWidget* parent) {
    auto* grid = new FieldGrid(GridColumns, parent);
    m_x = new SignalBox(grid);
    grid->addTitled(tr("Across"),
                    tr("The signal of the horizontal axis; also by dropping one of the tree here"), m_x);
    m_y = new SignalBox(grid);
    grid->addTitled(tr("Up"), tr("The signal of the vertical axis; also by dropping one of the tree here"),
                    m_y);
    m_stretch = grid->addNumber(
        {tr("Last"), tr("The newest seconds are shown"), QStringLiteral("s"), 1, 0.1, 3600.0, 1.0});
    m_stretch->setQuantity(10.0);
    m_ellipse = new QCheckBox(tr("&Ellipse"), grid);
    m_ellipse->setToolTip(
        tr("Fits an ellipse through the points; they must go round it several times (Alt+E)"));
    m_ellipse->setChecked(true);
    grid->addPlain(m_ellipse);
    for (SignalBox* box : {m_x, m_y}) {
        connect(box, &SignalBox::chosen, this, [this] {
            want();
            askAnew();
        });
    }
    connect(m_stretch, &widgets::QuantityEdit::edited, this, &XyPanel::askAnew);
    connect(m_ellipse, &QCheckBox::toggled, this, &XyPanel::askAnew);
    return grid;
}

void XyPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    want();
}

void XyPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

void XyPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected || session.returns() > 0) {
        return; // what was measured can be looked at without the device
    }
    m_pages->setCurrentIndex(1);
    m_x->setCatalogue(session.catalogue(), {"hall.a"});
    m_y->setCatalogue(session.catalogue(), {"hall.b"});
    want();
    askAnew();
}

/// Sent only while somebody looks.
void XyPanel::want() {
    std::vector<std::string> wanted;
    for (const SignalBox* box : {m_x, m_y}) {
        if (isVisible() && !box->signal().empty()) {
            wanted.push_back(box->signal());
        }
    }
    m_bench.liveSignals().want(this, std::move(wanted));
}

void XyPanel::askAnew() {
    m_seen.reset();
    m_task.cancel();
    ask();
}

void XyPanel::ask() {
    const std::uint64_t revision = m_bench.history().revision();
    if (!isVisible() || m_seen == revision || m_task.isBusy() || m_x->signal().empty()) {
        return;
    }
    m_seen = revision;
    const auto stretch = [this](const SignalBox& box) {
        return lastStretch(m_bench.history(), box.signal(), m_stretch->value(), MostRows);
    };
    m_task.run(
        [x = stretch(*m_x), y = stretch(*m_y), isFitted = m_ellipse->isChecked(),
         xFactor = shown(*m_x).factor, yFactor = shown(*m_y).factor] {
            const SignalPair all = pairUp(x, y);
            Answer answer{thinned(all, xFactor, yFactor), {}};
            if (isFitted) {
                answer.fit = control::fitHallEllipse(all.x, all.y);
            }
            return answer;
        },
        [this](const Answer& answer) { showAnswer(answer); });
}

DisplayQuantity XyPanel::shown(const SignalBox& box) const {
    const SignalSpec* spec = m_bench.session().catalogue().findSignal(box.signal());
    return spec != nullptr ? displayQuantity(spec->unit, m_bench.displayUnits()) : DisplayQuantity{};
}

void XyPanel::showAnswer(const Answer& answer) {
    const DisplayQuantity x = shown(*m_x);
    const DisplayQuantity y = shown(*m_y);
    widgets::Figure figure;
    const QString xWords = signalWords(m_x->signal());
    const QString yWords = signalWords(m_y->signal());
    figure.title = tr("%1 over %2").arg(yWords, xWords).toStdString();
    figure.x = {xWords.toStdString(), x.unit.toStdString(), false, {}, {}, {}};
    figure.isEqualScale = x.unit == y.unit;
    widgets::Panel panel;
    panel.y = {yWords.toStdString(), y.unit.toStdString(), false, {}, {}, {}};
    panel.height_px = PictureHeight_px;
    panel.curves.push_back(
        {tr("measured").toStdString(), answer.points.x, answer.points.y, widgets::CurveStyle::Points, {}});
    figure.panels.push_back(std::move(panel));
    m_words->clear();
    m_numbers->setVisible(answer.fit && *answer.fit);
    if (answer.fit) {
        showFit(*answer.fit, figure);
    }
    m_view->setFigure(std::move(figure));
}

void XyPanel::showFit(const Result<control::HallEllipseFit>& fit, widgets::Figure& figure) {
    if (!fit) {
        sayWarning(fit.error());
        return;
    }
    const DisplayQuantity x = shown(*m_x);
    const DisplayQuantity y = shown(*m_y);
    const control::HallEllipse& ellipse = fit->ellipse;
    const control::HallEllipse& error = fit->error;
    EllipseCurve curve = ellipseCurve(ellipse, EllipsePoints);
    std::transform(curve.a.begin(), curve.a.end(), curve.a.begin(), [&](double a) { return x.factor * a; });
    std::transform(curve.b.begin(), curve.b.end(), curve.b.begin(), [&](double b) { return y.factor * b; });
    figure.panels.front().curves.push_back(
        {tr("ellipse").toStdString(), curve.a, curve.b, widgets::CurveStyle::Line, {}});
    const QString degree = QStringLiteral("\u00b0");
    m_numbers->setRows({estimate(tr("Centre of %1").arg(signalWords(m_x->signal())),
                                 x.factor * ellipse.offsetA_T, x.factor * error.offsetA_T, x.unit),
                        estimate(tr("Centre of %1").arg(signalWords(m_y->signal())),
                                 y.factor * ellipse.offsetB_T, y.factor * error.offsetB_T, y.unit),
                        estimate(tr("Amplitude of %1").arg(signalWords(m_x->signal())),
                                 x.factor * ellipse.amplitude_T, x.factor * error.amplitude_T, x.unit),
                        estimate(tr("Ratio of the amplitudes"), ellipse.gain_ratio, error.gain_ratio, {}),
                        estimate(tr("Phase beyond 90\u00b0"), radiansToDegrees(ellipse.quadrature_rad),
                                 radiansToDegrees(error.quadrature_rad), degree)});
    QStringList words;
    const QLocale locale;
    if (figure.isEqualScale) {
        const EllipseAxes axes = ellipseAxes(ellipse);
        words << tr("Longest and shortest radius %1 and %2 %3")
                     .arg(locale.toString(x.factor * axes.large, 'g', 5),
                          locale.toString(x.factor * axes.small, 'g', 5), x.unit);
    }
    words << tr("rms distance of the points from the ellipse %1 % of the amplitude")
                 .arg(locale.toString(PerCent * fit->residual_ratio, 'g', 3));
    m_words->setText(words.join(QStringLiteral("; ")) + '.');
    showRole(*m_words, widgets::Role::Muted);
}

void XyPanel::sayWarning(const Error& error) {
    m_words->setText(widgets::inWords(error.message) + QStringLiteral(": ") + widgets::inWords(error.hint));
    showRole(*m_words, widgets::Role::Warn);
}

} // namespace halbench::app
