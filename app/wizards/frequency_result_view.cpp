#include "app/wizards/frequency_result_view.h"

#include "app/report/frequency_figures.h"
#include "app/wizards/frequency_words.h"
#include "app/wizards/identify_words.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workspaces/document_files.h"
#include "widgets/figure_view.h"
#include "widgets/phrasebook.h"
#include "widgets/theme_style.h"

#include <QEvent>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>

namespace halbench::app {

FrequencyResultView::FrequencyResultView(QWidget* parent) : QWidget(parent), m_figures(new QTabWidget(this)) {
    QWidget* words = buildWords();
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
    m_both = new WordsAndPictures(words, m_table, m_figures, this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_both);
}

QWidget* FrequencyResultView::buildWords() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, widgets::PanelMargin_px, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    m_verdict = new widgets::VerdictView(page);
    m_table = new widgets::EstimateTable(page);
    m_use = new QLabel(page);
    m_provenance = new QLabel(page);
    for (QLabel* label : {m_use, m_provenance}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    widgets::setRole(*m_provenance, widgets::Role::Muted);
    for (QWidget* part : std::initializer_list<QWidget*>{m_verdict, m_table, m_use, m_provenance}) {
        column->addWidget(part);
    }
    column->addStretch(1);
    return page;
}

void FrequencyResultView::setResult(const FrequencyResult& result, const ResultHeader& header) {
    m_result = result;
    m_header = header;
    refresh();
    m_both->shareAnew();
}

void FrequencyResultView::refresh() {
    m_verdict->setVerdict(verdictLevel(m_result.quality.verdict), verdictTitle(m_result.quality),
                          remarksOf(m_result.quality.findings));
    m_table->setRows(frequencyRows(m_result));
    m_table->setAccessibleName(tr("Margins and fitted rotor"));
    m_both->setWordsName(tr("Margins and fitted rotor"));
    m_use->setText(frequencyUse(m_result));
    m_provenance->setText(provenanceText(m_header, m_result.duration_s, m_result.highestTemperature_degC));
    struct Tab {
        QString name, help;
        std::optional<FrequencyView> view; ///< absent: the raw record, never the last to be reached
    };
    const Tab tabs[] = {
        {tr("Open loop"),
         tr("With the gains on the board: magnitude, phase and coherence over one frequency"),
         FrequencyView::OpenLoop},
        {tr("Plant"), tr("From the current to the measured angle, with the rotor that fits"),
         FrequencyView::Plant},
        {tr("Raw record"), tr("Speed and current over time, as recorded"), {}},
        {tr("Closed loop"), tr("From the reference to the measured angle"), FrequencyView::ClosedLoop}};
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        const Tab& tab = tabs[i];
        m_figures->setTabText(static_cast<int>(i), tab.name);
        m_figures->setTabToolTip(static_cast<int>(i), tab.help);
        const bool hasPoints = !m_result.points.empty();
        m_views[i]->setFigure(!tab.view   ? excitationFigure(m_result).value_or(widgets::Figure{})
                              : hasPoints ? frequencyFigure(m_result, *tab.view)
                                          : widgets::Figure{});
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
