#include "app/wizards/frequency_result_view.h"

#include "app/figures/frequency_figures.h"
#include "app/wizards/frequency_text.h"
#include "app/wizards/identify_text.h"
#include "app/wizards/result_text.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workbench/document_files.h"
#include "app/workspaces/parts/figure_units.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>

namespace halbench::app {

FrequencyResultView::FrequencyResultView(QWidget* parent) : QWidget(parent), m_figures(new QTabWidget(this)) {
    m_words = new ResultWords;
    for (widgets::FigureView*& view : m_views) {
        view = new widgets::FigureView(m_figures);
        m_figures->addTab(view, {});
        connect(view, &widgets::FigureView::exportRequested, this, [this, view = view] {
            savePicture(this, m_chooser != nullptr ? *m_chooser : FileChooser(),
                        QStringLiteral("response.svg"), m_files, *view, [this](const Error& error) {
                            notSaved(widgets::inWords(error.message), widgets::inWords(error.hint));
                        });
        });
    }
    m_both = new WordsAndPictures(m_words, &m_words->table(), m_figures, this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_both);
}

void FrequencyResultView::setResult(const FrequencyResult& result, const ResultHeader& header) {
    m_result = result;
    m_header = header;
    refresh();
    m_both->shareAnew();
}

void FrequencyResultView::setFrequencyUnit(FrequencyUnit unit) {
    if (unit != m_unit) {
        m_unit = unit;
        refresh();
    }
}

void FrequencyResultView::refresh() {
    m_words->setQuality(m_result.quality);
    m_words->table().setRows(frequencyRows(m_result));
    m_words->table().setAccessibleName(tr("Margins and fitted rotor"));
    m_both->setWordsName(tr("Margins and fitted rotor"));
    m_words->setUse(frequencyUse(m_result));
    m_words->setProvenance(provenanceText(m_header, m_result.duration_s, m_result.highestTemperature_degC));
    struct Tab {
        QString name, help;
        std::optional<FrequencyView> view; ///< absent: the raw record, never the last to be reached
    };
    const Tab tabs[] = {
        {tr("Open loop"), tr("With the device's gains: magnitude, phase and coherence over frequency"),
         FrequencyView::OpenLoop},
        {tr("Plant"), tr("From current to measured angle, with the fitted rotor"), FrequencyView::Plant},
        {tr("Raw record"), tr("Speed and current over time, as recorded"), {}},
        {tr("Closed loop"), tr("From the reference to the measured angle"), FrequencyView::ClosedLoop}};
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        const Tab& tab = tabs[i];
        m_figures->setTabText(static_cast<int>(i), tab.name);
        m_figures->setTabToolTip(static_cast<int>(i), tab.help);
        const bool hasPoints = !m_result.points.empty();
        showInFrequencyUnit(*m_views[i],
                            !tab.view   ? excitationFigure(m_result).value_or(widgets::Figure{})
                            : hasPoints ? frequencyFigure(m_result, *tab.view)
                                        : widgets::Figure{},
                            m_unit);
    }
    m_figures->setAccessibleName(tr("Pictures of the frequency response"));
}

void FrequencyResultView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

} // namespace halbench::app
