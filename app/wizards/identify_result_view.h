#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/identify/identify_procedure.h"
#include "app/workbench/display_quantity.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"

#include <QWidget>

class QLabel;
class QTabWidget;

namespace halbench::widgets {
class FigureView;
class MessageBar;
} // namespace halbench::widgets

namespace halbench::app {

class ResultWords;
class WordsAndPictures;

/// An identification as it is read: verdict and findings, values with their intervals, what would supply
/// what is missing, provenance; beside them the fit with its residuals and the joint region.
class IdentifyResultView : public QWidget {
    Q_OBJECT
public:
    explicit IdentifyResultView(QWidget* parent = nullptr);

    void setResult(const IdentifyResult& result, const ResultHeader& header);
    void setUnits(const DisplayUnits& units);
    void setFileChooser(const FileChooser* chooser) { m_chooser = chooser; }

Q_SIGNALS:
    void notSaved(const QString& message, const QString& remedy);
    void helpRequested(const QString& page);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    IdentifyResult m_result;
    ResultHeader m_header;
    DisplayUnits m_units; ///< of the pictures; the values of the table stay in SI, as in the file
    const FileChooser* m_chooser = nullptr;
    FileQueue m_files;
    ResultWords* m_words = nullptr;
    QLabel* m_friction = nullptr;
    WordsAndPictures* m_both = nullptr;
    QTabWidget* m_figures = nullptr;
    widgets::FigureView* m_fit = nullptr;
    widgets::FigureView* m_region = nullptr;
};

} // namespace halbench::app
