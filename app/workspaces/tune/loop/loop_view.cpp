#include "app/workspaces/tune/loop/loop_view.h"

#include "app/figures/loop_figures.h"
#include "app/figures/root_locus_figure.h"
#include "app/workbench/signals/loop_phase.h"
#include "app/workspaces/parts/figure_units.h"
#include "widgets/figure/figure_cursor.h"
#include "widgets/figure/figure_view.h"
#include "widgets/theme/theme_style.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace halbench::app {
namespace {

struct Loops {
    const AnalysisResult& predicted;
    const std::optional<AnalysisResult>& present;
    const std::vector<NamedLoop>& others;
    const std::optional<MeasuredLoop>& measured;
    const std::optional<LoopUncertainty>& uncertainty;
};

/// Without panels: an unstable loop has no sensitivity.
widgets::Figure figureOf(LoopView::View view, const Loops& loops) {
    switch (view) {
    case LoopView::View::Bode:
        return openLoopFigure(loops.predicted, loops.present, loops.others, loops.measured,
                              loops.uncertainty);
    case LoopView::View::Nyquist:
        return nyquistFigure(loops.predicted, loops.present, loops.others, loops.measured);
    case LoopView::View::Nichols:
        return nicholsFigure(loops.predicted, loops.present, loops.others, loops.measured);
    case LoopView::View::Sensitivity:
        return sensitivityFigure(loops.predicted, loops.present, loops.others).value_or(widgets::Figure{});
    case LoopView::View::RootLocus:
        break;
    }
    return rootLocusFigure(loops.predicted, loops.present, loops.others);
}

} // namespace

LoopView::LoopView(QWidget* parent)
    : QWidget(parent), m_label(new QLabel(this)), m_choice(new QComboBox(this)), m_wrap(new QCheckBox(this)),
      m_picture(new widgets::FigureView(this)), m_note(new QLabel(this)), m_row(new QHBoxLayout) {
    auto* choice = new QHBoxLayout;
    choice->setSpacing(widgets::PanelMargin_px);
    choice->addWidget(m_label);
    choice->addWidget(m_choice);
    choice->addStretch(1);
    m_row->setSpacing(widgets::PanelMargin_px); // of its own: all in one do not fit a small window
    m_row->addWidget(m_wrap);
    m_row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GridStep_px);
    column->addLayout(choice);
    column->addLayout(m_row);
    column->addWidget(m_note);
    column->addWidget(m_picture, 1);
    m_label->setBuddy(m_choice);
    m_note->setWordWrap(true);
    m_note->hide();
    for (int i = 0; i < Views; ++i) {
        m_choice->addItem(QString());
    }
    connect(m_choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &LoopView::choose);
    connect(m_wrap, &QCheckBox::toggled, this, &LoopView::show);
    connectHandles();
    sayWords();
}

void LoopView::addTool(QWidget& tool) {
    m_row->addWidget(&tool);
}

void LoopView::sayWords() {
    m_label->setText(tr("View"));
    const QString names[] = {tr("Bode"), tr("Nyquist"), tr("Nichols"), tr("Sensitivity"), tr("Root locus")};
    for (int i = 0; i < m_choice->count(); ++i) {
        m_choice->setItemText(i, names[i]);
    }
    m_choice->setAccessibleName(tr("Open-loop plot"));
    m_choice->setToolTip(tr("Bode: magnitude and phase over frequency. Nyquist: locus around -1. Nichols: "
                            "magnitude over phase. Sensitivity: disturbance rejection and reference "
                            "tracking. Root locus: closed-loop poles over the gain"));
    m_wrap->setText(tr("Wrap the phase"));
    m_wrap->setToolTip(tr("Plot the phase between -180° and 180°"));
    m_wrap->setAccessibleName(m_wrap->text());
    m_note->setText(tr("Closed loop unstable: no sensitivity."));
    m_picture->setHandles(handlesOf(view()));
}

void LoopView::setLoops(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                        const std::vector<NamedLoop>& others, const std::optional<MeasuredLoop>& measured,
                        const std::optional<LoopUncertainty>& uncertainty) {
    m_hasLoops = true;
    m_figure = figureOf(view(), {predicted, present, others, measured, uncertainty});
    findGrips(predicted);
    show();
}

void LoopView::setView(View view) {
    m_choice->setCurrentIndex(static_cast<int>(view));
}

/// Nothing is drawn of loops that whoever owns this does not have any more.
void LoopView::choose() {
    m_hasLoops = false;
    m_figure = {};
    Q_EMIT loopsWanted();
    if (!m_hasLoops) {
        show();
    }
}

widgets::Figure LoopView::shown() const {
    const bool isWrapped = view() == View::Bode && m_wrap->isChecked() && !m_figure.panels.empty();
    return isWrapped ? withWrappedPhase(m_figure) : m_figure;
}

void LoopView::setFrequencyUnit(FrequencyUnit unit) {
    if (unit == m_unit) {
        return;
    }
    const auto read = m_picture->probedAlong();
    const double ratio = frequencyFactor(unit) / frequencyFactor(m_unit);
    m_unit = unit;
    if (m_probed) {
        m_probed = *m_probed * ratio; // waits while the root locus is shown
    }
    show();
    if (read) {
        m_picture->probeAlong(*read * ratio); // the same frequency under another number
    }
}

void LoopView::show() {
    const widgets::Figure figure = shown();
    m_wrap->setVisible(view() == View::Bode);
    if (widgets::alongAxis(m_picture->figure()) != nullptr) {
        m_probed = m_picture->probedAlong(); // the root locus has no frequency: it waits for the next view
    }
    m_note->setVisible(figure.panels.empty() && m_hasLoops);
    showInFrequencyUnit(*m_picture, figure, m_unit);
    if (m_probed && !m_picture->probedAlong()) {
        m_picture->probeAlong(*m_probed);
    }
    m_picture->setHandles(handlesOf(view()));
}

void LoopView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        sayWords();
    }
}

} // namespace halbench::app
