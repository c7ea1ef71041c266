#include "app/workspaces/tune/loop/loop_sliders.h"

#include "app/workspaces/parts/panel_parts.h"
#include "control/base/units.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using control::CrossoverAim;
using control::CrossoverLimit;

constexpr int SpeedPlaces = 2000; ///< between the slowest and the fastest crossover, a ratio each
constexpr double Places_per_deg = 10.0;

QString pairWords(const CrossoverAim& aim) {
    return QStringLiteral("%1 Hz, %2\u00b0")
        .arg(widgets::numberText(aim.crossover_rad_s / (2.0 * Pi), 3),
             widgets::numberText(aim.phaseMargin_deg, 3));
}

} // namespace

LoopSliders::LoopSliders(QWidget* parent) : QWidget(parent), m_note(makeNote(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(widgets::PanelMargin_px);
    grid->setVerticalSpacing(widgets::GridStep_px);
    grid->setColumnStretch(1, 1);
    m_speed = addSlider(m_speedName, m_speedNumber, 0);
    m_margin = addSlider(m_marginName, m_marginNumber, 1);
    m_speed->setObjectName(QStringLiteral("speed"));
    m_speed->setRange(0, SpeedPlaces);
    m_speed->setSingleStep(6); // 2 %
    m_speed->setPageStep(72);  // a quarter
    m_margin->setObjectName(QStringLiteral("robustness"));
    m_margin->setRange(static_cast<int>(control::crossover::LeastMargin_deg * Places_per_deg),
                       static_cast<int>(control::crossover::MostMargin_deg * Places_per_deg));
    m_margin->setSingleStep(static_cast<int>(Places_per_deg));
    m_margin->setPageStep(static_cast<int>(5.0 * Places_per_deg));
    grid->addWidget(m_note, 2, 0, 1, 4);
    reserveLines(*m_note, 1); // as long as what is said of a limit
    connect(m_speed, &QSlider::valueChanged, this,
            [this](int place) { Q_EMIT crossoverMoved(crossoverAt(place)); });
    connect(m_margin, &QSlider::valueChanged, this,
            [this](int place) { Q_EMIT phaseMarginMoved(place / Places_per_deg); });
    refreshWords();
    setLoop(std::nullopt, {});
}

void LoopSliders::setHistory(QAction& undo, QAction& redo) {
    auto* grid = static_cast<QGridLayout*>(layout());
    int line = 0;
    for (QAction* action : {&undo, &redo}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        grid->addWidget(button, line++,
                        3); // beside a slider each: a row of their own would cost the gains a line
        const auto name = [button, action] { button->setAccessibleName(action->text().remove('&')); };
        connect(action, &QAction::changed, button, name);
        name();
    }
}

QSlider* LoopSliders::addSlider(QLabel*& name, QLabel*& number, int line) {
    name = new QLabel(this);
    number = new QLabel(this);
    auto* slider = new QSlider(Qt::Horizontal, this);
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->addWidget(name, line, 0);
    grid->addWidget(slider, line, 1);
    grid->addWidget(number, line, 2);
    name->setBuddy(slider);
    number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    number->setMinimumWidth(number->fontMetrics().horizontalAdvance(QStringLiteral("00.00 Hz")));
    connect(slider, &QSlider::sliderPressed, this, &LoopSliders::taken);
    connect(slider, &QSlider::sliderReleased, this, &LoopSliders::released);
    return slider;
}

double LoopSliders::crossoverAt(int place) const {
    const double slowest_rad_s = control::slowestCrossover_rad_s(m_timing);
    const double most_ratio = control::fastestCrossover_rad_s(m_timing) / slowest_rad_s;
    return slowest_rad_s * std::pow(most_ratio, static_cast<double>(place) / SpeedPlaces);
}

int LoopSliders::placeOf(double crossover_rad_s) const {
    const double slowest_rad_s = control::slowestCrossover_rad_s(m_timing);
    const double most_ratio = control::fastestCrossover_rad_s(m_timing) / slowest_rad_s;
    const double share = std::log(crossover_rad_s / slowest_rad_s) / std::log(most_ratio);
    return static_cast<int>(std::lround(SpeedPlaces * std::clamp(share, 0.0, 1.0)));
}

void LoopSliders::setLoop(const std::optional<CrossoverAim>& aim, const control::LoopTiming& timing) {
    const bool canCross = aim && aim->crossover_rad_s > 0.0 && std::isfinite(aim->phaseMargin_deg);
    m_aim = canCross ? aim : std::nullopt;
    m_timing = timing;
    for (QSlider* slider : {m_speed, m_margin}) {
        slider->setEnabled(canCross);
    }
    const QSignalBlocker quietSpeed(m_speed);
    const QSignalBlocker quietMargin(m_margin);
    if (canCross && !m_speed->isSliderDown()) {
        m_speed->setValue(placeOf(aim->crossover_rad_s));
    }
    if (canCross && !m_margin->isSliderDown()) {
        m_margin->setValue(static_cast<int>(std::lround(aim->phaseMargin_deg * Places_per_deg)));
    }
    showNumbers();
}

void LoopSliders::showNumbers() {
    const QString none = QStringLiteral("\u2013");
    m_speedNumber->setText(
        m_aim ? widgets::numberText(m_aim->crossover_rad_s / (2.0 * Pi), 3) + QStringLiteral(" Hz") : none);
    m_marginNumber->setText(m_aim ? widgets::numberText(m_aim->phaseMargin_deg, 3) + QStringLiteral("\u00b0")
                                  : none);
    m_speed->setAccessibleDescription(m_speedNumber->text());
    m_margin->setAccessibleDescription(m_marginNumber->text());
}

void LoopSliders::sayLimit(const CrossoverAim& wanted, const control::CrossoverDesign& design) {
    const QString reached = pairWords(design.reached);
    QString why;
    switch (design.limit) {
    case CrossoverLimit::None:
        break;
    case CrossoverLimit::Range:
        why = tr("Limited to %1 (end of range).").arg(reached);
        break;
    case CrossoverLimit::Derivative:
        why = tr("Limited to %1 (K_D would become negative).").arg(reached);
        break;
    case CrossoverLimit::Stiffness:
        why = tr("Limited to %1 (K_P would become zero).").arg(reached);
        break;
    case CrossoverLimit::Stability:
        why = tr("Limited to %1 (gain margin %2).")
                  .arg(reached, widgets::numberText(control::crossover::LeastGainMargin_ratio, 2));
        break;
    }
    sayProblem(why);
    m_note->setToolTip(
        why.isEmpty() ? why : tr("Requested %1; set to the nearest possible value.").arg(pairWords(wanted)));
}

void LoopSliders::sayProblem(const QString& text) {
    m_note->setText(text);
    showRole(*m_note, text.isEmpty() ? widgets::Role::Muted : widgets::Role::Warn);
}

void LoopSliders::refreshWords() {
    m_speedName->setText(tr("S&peed"));
    m_speed->setAccessibleName(tr("Speed: gain crossover"));
    m_speed->setToolTip(tr("Gain crossover: closed-loop bandwidth; the phase margin is kept if possible. "
                           "Arrow keys: 2 %, Page Up/Down: 25 %"));
    m_marginName->setText(tr("&Robustness"));
    m_margin->setAccessibleName(tr("Robustness: phase margin"));
    m_margin->setToolTip(tr("Phase margin at the present crossover. Arrow keys: 1°, Page Up/Down: 5°"));
}

void LoopSliders::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
