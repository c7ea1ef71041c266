#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/workbench/display_quantity.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"

#include <QWidget>

#include <array>

class QTabWidget;

namespace halbench::widgets {
class FigureView;
} // namespace halbench::widgets

namespace halbench::app {

class ResultWords;
class WordsAndPictures;

/// A frequency response as it is read: verdict and findings, margins with intervals or why they are withheld,
/// the rotor that fits; beside them open loop, plant and closed loop with coherence, and the raw record.
class FrequencyResultView : public QWidget {
    Q_OBJECT
public:
    explicit FrequencyResultView(QWidget* parent = nullptr);

    void setResult(const FrequencyResult& result, const ResultHeader& header);
    void setFrequencyUnit(FrequencyUnit unit); ///< of the pictures
    void setFileChooser(const FileChooser* chooser) { m_chooser = chooser; }

Q_SIGNALS:
    void notSaved(const QString& message, const QString& remedy);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    FrequencyResult m_result;
    ResultHeader m_header;
    FrequencyUnit m_unit = FrequencyUnit::Hertz;
    const FileChooser* m_chooser = nullptr;
    FileQueue m_files;
    ResultWords* m_words = nullptr;
    WordsAndPictures* m_both = nullptr;
    QTabWidget* m_figures = nullptr;
    std::array<widgets::FigureView*, 4> m_views{}; ///< open loop, plant, raw record, closed loop
};

} // namespace halbench::app
