#include "app/workspaces/analysis/xy_panel.h"

#include "app/documents/text/numbers.h"
#include "app/procedures/calibrate/ellipse_shape.h"
#include "app/workspaces/parts/field_grid.h"
#include "app/workspaces/parts/signal_box.h"
#include "control/base/distributions.h"
#include "control/base/units.h"
#include "devices/recording/recording_csv.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/display_units.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr std::size_t MostRows = std::size_t{1} << 17; ///< copied at once, about a millisecond
constexpr std::size_t DrawnPoints = 1500;              ///< the eye sees no more in such a cloud
constexpr std::size_t EllipsePoints = 180;
constexpr int GridColumns = 4;
constexpr int PictureHeight_px = 360;
constexpr double Probability95 = 0.975; ///< two-sided 95 %
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

widgets::EstimateRow estimate(const QString& name, double value, double halfWidth, const QString& unit) {
    return {name, value, value - halfWidth, value + halfWidth, unit, {}, {}};
}

} // namespace

XyPanel::XyPanel(Workbench& bench, QWidget* parent) : LivePicture(bench, parent) {
    begin(tr("No data to show"),
          tr("Two signals plotted against each other, initially the Hall sensors with their ellipse. Connect "
             "a device: choose one on the left, or try the simulated motor."),
          buildContent());
}

QWidget* XyPanel::buildContent() {
    auto* content = new QWidget(this);
    QVBoxLayout* column = makePanelColumn(content);
    column->addWidget(buildFields(content));
    m_view =
        makeView(content, tr("Arrow keys move along the points; Ctrl+C copies the picture, Ctrl+E saves it"),
                 QStringLiteral("xy.svg"));
    column->addWidget(m_view, 1);
    addData({m_view}, tr("Save all points as a table (CSV), in SI units"), QStringLiteral("xy.csv"));
    m_words = makeWords(content, tr("Summary of the ellipse"));
    column->addWidget(m_words);
    m_numbers = new widgets::EstimateTable(content);
    m_numbers->setAccessibleName(tr("Fitted ellipse"));
    column->addWidget(m_numbers);
    return content;
}

QWidget* XyPanel::buildFields(QWidget* parent) {
    auto* grid = new FieldGrid(GridColumns, parent);
    m_x = makeBox(grid);
    grid->addTitled(tr("X"), tr("Signal of the horizontal axis; a signal can also be dropped here"), m_x);
    m_y = makeBox(grid);
    grid->addTitled(tr("Y"), tr("Signal of the vertical axis; a signal can also be dropped here"), m_y);
    m_stretch = grid->addNumber({tr("Time span"), tr("Length of the data shown, up to now"),
                                 QStringLiteral("s"), 1, 0.1, 3600.0, 1.0});
    m_stretch->setQuantity(10.0);
    m_ellipse = new QCheckBox(tr("Ellip&se"), grid);
    m_ellipse->setToolTip(tr("Fit an ellipse to the points; needs several turns (Alt+E)"));
    m_ellipse->setChecked(true);
    grid->addPlain(m_ellipse);
    connect(m_stretch, &widgets::QuantityEdit::edited, this, &XyPanel::askAnew);
    connect(m_ellipse, &QCheckBox::toggled, this, &XyPanel::askAnew);
    return grid;
}

void XyPanel::takeCatalogue(const devices::Catalogue& catalogue) {
    m_x->setCatalogue(catalogue, {"hall.a"});
    m_y->setCatalogue(catalogue, {"hall.b"});
}

void XyPanel::compute() {
    const auto stretch = [this](const SignalBox& box) {
        return lastStretch(bench().history(), box.signal(), m_stretch->value(), MostRows);
    };
    const SignalStretch xStretch = stretch(*m_x);
    const SignalStretch yStretch = stretch(*m_y);
    task().run(
        [x = xStretch, y = yStretch, xName = m_x->signal(), yName = m_y->signal(),
         isFitted = m_ellipse->isChecked(), xFactor = shown(*m_x).factor, yFactor = shown(*m_y).factor] {
            const auto all = std::make_shared<const SignalPair>(pairUp(x, y));
            StreamLayout layout;
            layout.columns = {{xName, x.unit}, {yName, y.unit}};
            const std::vector<std::string> columns = devices::csvColumnNames(layout);
            Answer answer{thinned(*all, xFactor, yFactor), all, columns[0], columns[1], {}};
            if (isFitted) {
                answer.fit = control::fitHallEllipse(all->x, all->y);
            }
            return answer;
        },
        [this](const Answer& answer) {
            m_shown = answer;
            showAnswer(answer);
        });
}

/// All of the stretch, not only what is drawn of it; rows in which one is missing are none.
LivePicture::Table XyPanel::table() const {
    if (m_shown.all == nullptr || m_shown.all->x.empty()) {
        return {};
    }
    return [all = m_shown.all, header = m_shown.xColumn + ',' + m_shown.yColumn + '\n'] {
        std::string text = header;
        for (std::size_t row = 0; row < all->x.size(); ++row) {
            text += formatNumber(all->x[row]) + ',' + formatNumber(all->y[row]) + '\n';
        }
        return text;
    };
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
    const double sigmas = control::studentQuantile(Probability95, fit->parts - 1);
    EllipseCurve curve = ellipseCurve(ellipse, EllipsePoints);
    std::transform(curve.a.begin(), curve.a.end(), curve.a.begin(), [&](double a) { return x.factor * a; });
    std::transform(curve.b.begin(), curve.b.end(), curve.b.begin(), [&](double b) { return y.factor * b; });
    figure.panels.front().curves.push_back(
        {tr("ellipse").toStdString(), curve.a, curve.b, widgets::CurveStyle::Line, {}});
    const QString degree = QStringLiteral("\u00b0");
    m_numbers->setRows(
        {estimate(tr("Centre of %1").arg(signalWords(m_x->signal())), x.factor * ellipse.offsetA_T,
                  x.factor * sigmas * error.offsetA_T, x.unit),
         estimate(tr("Centre of %1").arg(signalWords(m_y->signal())), y.factor * ellipse.offsetB_T,
                  y.factor * sigmas * error.offsetB_T, y.unit),
         estimate(tr("Amplitude of %1").arg(signalWords(m_x->signal())), x.factor * ellipse.amplitude_T,
                  x.factor * sigmas * error.amplitude_T, x.unit),
         estimate(tr("Amplitude ratio"), ellipse.gain_ratio, sigmas * error.gain_ratio, {}),
         estimate(tr("Phase error from 90°"), radiansToDegrees(ellipse.quadrature_rad),
                  radiansToDegrees(sigmas * error.quadrature_rad), degree)});
    QStringList words;
    if (figure.isEqualScale) {
        const EllipseAxes axes = ellipseAxes(ellipse);
        words << tr("Semi-axes %1 and %2 %3")
                     .arg(widgets::numberText(x.factor * axes.large, 5),
                          widgets::numberText(x.factor * axes.small, 5), x.unit);
    }
    words << tr("rms residual of the ellipse %1 % of the amplitude")
                 .arg(widgets::numberText(PerCent * fit->residual_ratio, 3));
    m_words->setText(words.join(QStringLiteral("; ")) + '.');
    showRole(*m_words, widgets::Role::Muted);
}

} // namespace halbench::app
