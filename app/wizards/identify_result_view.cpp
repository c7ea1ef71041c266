#include "app/wizards/identify_result_view.h"

#include "app/report/identification_figures.h"
#include "app/wizards/identify_words.h"
#include "widgets/estimate_table.h"
#include "widgets/figure_view.h"
#include "widgets/phrasebook.h"
#include "widgets/theme_style.h"
#include "widgets/verdict_view.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStyle>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr double MostWords_ratio = 0.55; ///< of the width; the pictures get the rest

} // namespace

IdentifyResultView::IdentifyResultView(QWidget* parent)
    : QWidget(parent), m_figures(new QTabWidget(this)), m_fit(new widgets::FigureView(m_figures)),
      m_region(new widgets::FigureView(m_figures)) {
    m_figures->addTab(m_fit, {});
    m_figures->addTab(m_region, {});
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setAccessibleName(tr("Identified values"));
    scroll->setWidget(buildWords());
    m_splitter = new QSplitter(Qt::Horizontal, this);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(scroll);
    m_splitter->addWidget(m_figures);
    m_splitter->setStretchFactor(1, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_splitter);
    for (widgets::FigureView* view : {m_fit, m_region}) {
        connect(view, &widgets::FigureView::exportRequested, this, [this, view] { savePicture(*view); });
    }
}

QWidget* IdentifyResultView::buildWords() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, widgets::PanelMargin_px, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    m_verdict = new widgets::VerdictView(page);
    m_table = new widgets::EstimateTable(page);
    m_missing = new QLabel(page);
    m_provenance = new QLabel(page);
    for (QLabel* label : {m_missing, m_provenance}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    widgets::setRole(*m_provenance, widgets::Role::Muted);
    column->addWidget(m_verdict);
    column->addWidget(m_table);
    column->addWidget(m_missing);
    column->addWidget(m_provenance);
    column->addStretch(1);
    return page;
}

void IdentifyResultView::setResult(const IdentifyResult& result, const ResultHeader& header) {
    m_result = result;
    m_header = header;
    refresh();
}

void IdentifyResultView::refresh() {
    m_verdict->setVerdict(verdictLevel(m_result.quality.verdict), verdictTitle(m_result.quality),
                          remarksOf(m_result.quality.findings));
    m_table->setRows(estimateRows(m_result));
    m_table->setAccessibleName(tr("Identified values"));
    m_missing->setText(missingText(m_result));
    m_missing->setVisible(!m_missing->text().isEmpty());
    m_provenance->setText(provenanceText(m_header, m_result));
    // The table is as wide as its columns where that leaves room for the pictures.
    const int table_px = m_table->neededWidth() + 2 * widgets::PanelMargin_px +
                         style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const int words_px = std::min(table_px, static_cast<int>(MostWords_ratio * m_splitter->width()));
    m_splitter->setSizes({words_px, std::max(1, m_splitter->width() - words_px)});
    const auto fit = steadySpeedFigure(m_result);
    const auto region = jointRegion(m_result);
    m_fit->setFigure(fit.value_or(widgets::Figure{}));
    m_region->setFigure(region ? region->figure : widgets::Figure{});
    m_figures->setTabEnabled(1, region.has_value());
    m_figures->setVisible(fit || region);
    m_figures->setTabText(0, tr("Fit and residuals"));
    m_figures->setTabText(1, tr("Joint region"));
    m_figures->setTabToolTip(0, tr("Steady speed against current, and what the fit leaves over"));
    m_figures->setTabToolTip(1, tr("Where damping and friction lie together with 95 % probability"));
    m_figures->setAccessibleName(tr("Pictures of the identification"));
}

void IdentifyResultView::savePicture(const widgets::FigureView& view) {
    if (m_chooser == nullptr || !m_chooser->save) {
        return;
    }
    const QString path = m_chooser->save(
        this, {tr("Save picture"), QStringLiteral("identification.svg"), tr("Picture (*.svg *.png)")});
    if (path.isEmpty()) {
        return;
    }
    m_files.run(view.saving(path), [this](const Result<void>& saved) {
        if (!saved) {
            Q_EMIT notSaved(widgets::inWords(saved.error().message), widgets::inWords(saved.error().hint));
        }
    });
}

void IdentifyResultView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

} // namespace halbench::app
