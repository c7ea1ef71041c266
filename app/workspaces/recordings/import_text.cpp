#include "app/workspaces/recordings/import_text.h"

#include "app/workspaces/parts/panel_parts.h"
#include "control/base/unit_text.h"
#include "devices/formats/csv_text.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>

#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr int Digits = 9;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::ImportWords)
};

QString headerOf(const devices::CsvPlan& plan, std::size_t index) {
    const devices::CsvColumn& column = plan.columns[index];
    const bool isTime = plan.time == index;
    const QString name = isTime ? Words::tr("time") : QString::fromStdString(column.signal);
    const QString unit = !column.isUnitKnown   ? Words::tr("unit not known")
                         : column.unit.empty() ? Words::tr("no unit")
                                               : QString::fromStdString(unitText(column.unit));
    const QString theirs =
        column.header.empty() ? Words::tr("column %1").arg(index + 1) : QString::fromStdString(column.header);
    return QStringLiteral("%1 [%2]\n%3").arg(name, unit, Words::tr("from %1").arg(theirs));
}

QString number(double value) {
    return std::isfinite(value) ? widgets::numberText(value, Digits) : QStringLiteral("–");
}

} // namespace

ImportPreview previewOf(const TableLook& look) {
    ImportPreview preview;
    const devices::CsvPlan& plan = look.plan;
    const Recording& first = look.first;
    if (!plan.time) {
        preview.headers << Words::tr("time [s]\nby %1 rows a second")
                               .arg(widgets::numberText(plan.rate_Hz.value_or(0.0), Digits));
    }
    for (std::size_t i = 0; i < plan.columns.size(); ++i) {
        preview.headers << headerOf(plan, i);
    }
    const std::size_t width = first.layout->columns.size();
    for (std::size_t row = 0; row < first.rows(); ++row) {
        QStringList cells;
        if (!plan.time) {
            cells << number(first.time_s[row]);
        }
        std::size_t signal = 0; // the recording has the time beside its columns
        for (std::size_t i = 0; i < plan.columns.size(); ++i) {
            cells << number(plan.time == i ? first.time_s[row] : first.values[row * width + signal++]);
        }
        preview.rows.push_back(cells);
    }
    return preview;
}

ImportPreview linesOf(const devices::CsvPlan& plan) {
    ImportPreview preview;
    if (!plan.dialect) {
        preview.headers << Words::tr("First lines of the file");
    }
    for (std::size_t i = 0; i < plan.columns.size(); ++i) {
        preview.headers << Words::tr("column %1").arg(i + 1);
    }
    for (const std::string& line : plan.firstLines) {
        QStringList cells;
        std::vector<devices::CsvCell> parts;
        if (plan.dialect && devices::splitCsv(line, plan.dialect->separator, parts)) {
            for (const devices::CsvCell& part : parts) {
                cells << QString::fromUtf8(part.text.data(), static_cast<int>(part.text.size()));
            }
        } else {
            cells << QString::fromStdString(line);
        }
        preview.rows.push_back(cells);
    }
    return preview;
}

QString importRemedy(const Error& error) {
    const auto names = [&error](const char* option) { return error.hint.find(option) != std::string::npos; };
    if (names("--unit")) {
        return Words::tr("Change the column's name or unit below, or choose another time column above.");
    }
    if (names("--time")) {
        return Words::tr("Choose the time column or enter the sampling rate above. If the rows are out of "
                         "order, sort the file.");
    }
    if (names("--")) {
        return Words::tr(
            "Set separator, decimal sign, header and time above to match the file, or correct the file.");
    }
    return widgets::inWords(error.hint);
}

QString questionWords(const devices::CsvQuestion& question) {
    return question.about == "numbers"  ? Words::tr("format of columns and numbers")
           : question.about == "header" ? Words::tr("meaning of the first lines")
           : question.about == "time"   ? Words::tr("time column")
                                        : widgets::inWords(question.text);
}

QString answerWords(const devices::CsvQuestion::Answer& answer) {
    if (answer.isRate) {
        return Words::tr("none: fixed sampling rate");
    }
    if (!answer.timeColumn.empty()) {
        return Words::tr("column %1").arg(QString::fromStdString(answer.timeColumn));
    }
    if (!answer.unit.first.empty()) {
        return Words::tr("unit of its numbers: %1").arg(QString::fromStdString(answer.unit.second));
    }
    if (answer.hints.header) {
        return widgets::inWords(answer.meaning);
    }
    QStringList words;
    if (answer.hints.separator) {
        words << Words::tr("separator %1")
                     .arg(QString::fromStdString(devices::separatorWord(*answer.hints.separator)));
    }
    if (answer.hints.decimal) {
        words << (*answer.hints.decimal == ',' ? Words::tr("decimal comma") : Words::tr("decimal point"));
    }
    const QString meaning = QString::fromStdString(answer.meaning); // "1 column: 1.5", what would be read
    return Words::tr("%1; read as %2")
        .arg(words.join(QStringLiteral(", ")), meaning.section(QStringLiteral(": "), 1));
}

QuestionRow::QuestionRow(devices::CsvQuestion question, QWidget* parent)
    : QWidget(parent), m_question(std::move(question)) {
    const QString text = questionWords(m_question);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(Words::tr("Uncertain: %1").arg(text), this);
    showRole(*label, widgets::Role::Warn);
    auto* answers = new QComboBox(this);
    label->setBuddy(answers);
    answers->setAccessibleName(text);
    answers->setToolTip(Words::tr("The file does not tell. Choose before importing"));
    answers->addItem(Words::tr("Please choose"));
    for (const devices::CsvQuestion::Answer& answer : m_question.answers) {
        answers->addItem(answerWords(answer));
    }
    row->addWidget(label);
    row->addWidget(answers, 1);
    connect(answers, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        if (index > 0) {
            Q_EMIT answered(m_question.answers[static_cast<std::size_t>(index) - 1]);
        }
    });
}

} // namespace halbench::app
