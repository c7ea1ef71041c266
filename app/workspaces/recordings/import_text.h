#pragma once

#include "app/workspaces/recordings/table_import.h"

#include <QStringList>
#include <QWidget>

#include <vector>

class QComboBox;

namespace halbench::app {

/// A table as it would be read, in words.
struct ImportPreview {
    QStringList headers; ///< what the column becomes, in which unit, and what it is called in the table
    std::vector<QStringList> rows;
};
ImportPreview previewOf(const TableLook& look);
/// While something is asked: the first lines as they are written, in their columns where these are known.
ImportPreview linesOf(const devices::CsvPlan& plan);

/// The remedy in the words of the window: the command line's names its options.
QString importRemedy(const Error& error);

QString questionWords(const devices::CsvQuestion& question);
QString answerWords(const devices::CsvQuestion::Answer& answer);

/// What only the user knows, with the answers that are possible.
class QuestionRow : public QWidget {
    Q_OBJECT

public:
    QuestionRow(devices::CsvQuestion question, QWidget* parent);

Q_SIGNALS:
    void answered(const halbench::devices::CsvQuestion::Answer& answer);

private:
    devices::CsvQuestion m_question;
};

} // namespace halbench::app
