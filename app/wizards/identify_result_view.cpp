#include "app/wizards/identify_result_view.h"

#include "app/figures/identification_figures.h"
#include "app/wizards/identify_text.h"
#include "app/wizards/note_label.h"
#include "app/wizards/result_text.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workbench/document_files.h"
#include "app/workspaces/parts/figure_units.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>

namespace halbench::app {

IdentifyResultView::IdentifyResultView(QWidget* parent)
    : QWidget(parent), m_figures(new QTabWidget(this)), m_fit(new widgets::FigureView(m_figures)),
      m_region(new widgets::FigureView(m_figures)) {
    m_figures->addTab(m_fit, {});
    m_figures->addTab(m_region, {});
    m_friction = noteLabel(this);
    connect(m_friction, &QLabel::linkActivated, this, &IdentifyResultView::helpRequested);
    m_words = new ResultWords(m_friction);
    m_both = new WordsAndPictures(m_words, &m_words->table(), m_figures, this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_both);
    for (widgets::FigureView* view : {m_fit, m_region}) {
        connect(view, &widgets::FigureView::exportRequested, this, [this, view] {
            savePicture(this, m_chooser != nullptr ? *m_chooser : FileChooser(),
                        QStringLiteral("identification.svg"), m_files, *view, [this](const Error& error) {
                            notSaved(widgets::inWords(error.message), widgets::inWords(error.hint));
                        });
        });
    }
}

void IdentifyResultView::setResult(const IdentifyResult& result, const ResultHeader& header) {
    m_result = result;
    m_header = header;
    refresh();
    m_both->shareAnew();
}

void IdentifyResultView::setUnits(const DisplayUnits& units) {
    m_units = units;
    refresh();
}

void IdentifyResultView::refresh() {
    m_words->setQuality(m_result.quality);
    m_words->table().setRows(estimateRows(m_result));
    m_words->table().setAccessibleName(tr("Identified values"));
    m_both->setWordsName(tr("Identified values"));
    showNote(*m_friction, frictionNote(m_result));
    m_words->setUse(missingText(m_result));
    m_words->setProvenance(provenanceText(m_header, m_result.duration_s, m_result.highestTemperature_degC));
    const auto fit = steadySpeedFigure(m_result);
    const auto region = jointRegion(m_result);
    m_fit->setFigure(inUnits(fit.value_or(widgets::Figure{}), m_units));
    m_region->setFigure(region ? region->figure : widgets::Figure{});
    m_figures->setTabEnabled(1, region.has_value());
    m_figures->setVisible(fit || region);
    m_figures->setTabText(0, tr("Fit and residuals"));
    m_figures->setTabText(1, tr("Confidence region"));
    m_figures->setTabToolTip(0, tr("Steady speed over current, and residuals"));
    m_figures->setTabToolTip(1, tr("Joint 95 % confidence region of damping and friction"));
    m_figures->setAccessibleName(tr("Pictures of the identification"));
}

void IdentifyResultView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

} // namespace halbench::app
