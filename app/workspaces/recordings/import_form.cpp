#include "app/workspaces/recordings/import_form.h"

#include "app/workspaces/parts/field_grid.h"
#include "widgets/controls/quantity_edit.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int GridColumns = 3;
constexpr double HighestRate_Hz = 1e6;
const QString ByRate = QStringLiteral("rate");

void choose(QComboBox& box, const QString& code) {
    const QSignalBlocker quiet(box);
    box.setCurrentIndex(std::max(0, box.findData(code)));
}

QString codeOf(const QComboBox& box) {
    return box.currentData().toString();
}

/// The first choice: what the program found by itself.
void sayFound(QComboBox& box, const std::optional<std::string>& code) {
    const int found = code ? box.findData(QString::fromStdString(*code), Qt::UserRole) : -1;
    box.setItemText(0, found > 0 ? ImportForm::tr("detected: %1").arg(box.itemText(found))
                                 : ImportForm::tr("not certain"));
}

QString wordOf(const std::vector<devices::CsvColumn>& columns, std::size_t index) {
    return QString::fromStdString(devices::columnWord(columns, index));
}

} // namespace

ImportForm::ImportForm(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* grid = new FieldGrid(GridColumns, this);
    column->addWidget(grid);
    m_separator = addChoice(*grid, tr("Separator"), tr("Character between the columns"),
                            {{tr("comma"), ","},
                             {tr("semicolon"), ";"},
                             {tr("tab"), "tab"},
                             {tr("space"), "space"},
                             {tr("none, one column"), "none"}});
    m_decimal = addChoice(*grid, tr("Decimal sign"), tr("Character before the decimals of a number"),
                          {{tr("point"), "."}, {tr("comma"), ","}});
    m_header = addChoice(*grid, tr("Header"), tr("Lines above the numbers"),
                         {{tr("none"), "0"}, {tr("names"), "1"}, {tr("names, then units"), "units"}});
    m_time = addChoice(*grid, tr("Time"), tr("Time column, or sampling rate in rows per second"), {});
    m_rate = grid->addNumber({tr("Sample rate"), tr("Sampling rate in rows per second"), QStringLiteral("Hz"),
                              3, 0.0, HighestRate_Hz, 100.0});
    connect(m_rate, &widgets::QuantityEdit::edited, this, &ImportForm::changed);
    reset();
}

QComboBox* ImportForm::addChoice(FieldGrid& grid, const QString& title, const QString& toolTip,
                                 const std::vector<std::pair<QString, QString>>& choices) {
    QComboBox* box = grid.addBox(title, toolTip);
    box->addItem(tr("not certain"), QString());
    for (const auto& [words, code] : choices) {
        box->addItem(words, code);
    }
    connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box] {
        if (box == m_time) {
            onTime();
        } else if (box != m_decimal) {
            Q_EMIT reshaped();
        }
        Q_EMIT changed();
    });
    return box;
}

void ImportForm::reset() {
    for (QComboBox* box : {m_separator, m_decimal, m_header, m_time}) {
        choose(*box, QString());
        box->setItemText(0, tr("not certain"));
    }
    m_rate->setQuantity(0.0);
    onTime();
}

void ImportForm::onTime() {
    m_rate->setEnabled(codeOf(*m_time) == ByRate);
}

void ImportForm::showPlan(const devices::CsvPlan& plan) {
    using devices::separatorWord;
    const auto& dialect = plan.dialect;
    const auto found = [&](auto word) { return dialect ? std::optional(word(*dialect)) : std::nullopt; };
    sayFound(*m_separator,
             found([](const devices::CsvDialect& one) { return separatorWord(one.separator); }));
    sayFound(*m_decimal, found([](const devices::CsvDialect& one) { return std::string(1, one.decimal); }));
    sayFound(*m_header,
             found([](const devices::CsvDialect& one) { return devices::headerWord(one.header); }));
    showColumns(plan);
}

void ImportForm::showColumns(const devices::CsvPlan& plan) {
    const QString chosen = codeOf(*m_time);
    const QSignalBlocker quiet(m_time);
    while (m_time->count() > 1) {
        m_time->removeItem(1);
    }
    for (std::size_t i = 0; i < plan.columns.size(); ++i) {
        const QString word = wordOf(plan.columns, i);
        m_time->addItem(tr("column %1").arg(word), word);
    }
    m_time->addItem(tr("none: use a fixed sampling rate"), ByRate);
    if (chosen != ByRate && m_time->findData(chosen) < 0) { // it is not yet known which columns there are
        m_time->addItem(tr("column %1").arg(chosen), chosen);
    }
    sayFound(*m_time,
             plan.time ? std::optional(wordOf(plan.columns, *plan.time).toStdString()) : std::nullopt);
    choose(*m_time, chosen);
    onTime();
}

devices::CsvImportRequest ImportForm::request() const {
    devices::CsvImportRequest request;
    for (const char separator : {',', ';', '\t', ' ', '\0'}) {
        if (codeOf(*m_separator).toStdString() == devices::separatorWord(separator)) {
            request.hints.separator = separator;
        }
    }
    if (const QString decimal = codeOf(*m_decimal); !decimal.isEmpty()) {
        request.hints.decimal = decimal[0].toLatin1();
    }
    using devices::CsvHeader;
    for (const CsvHeader header : {CsvHeader::None, CsvHeader::Names, CsvHeader::NamesAndUnits}) {
        if (codeOf(*m_header).toStdString() == devices::headerWord(header)) {
            request.hints.header = header;
        }
    }
    if (const QString time = codeOf(*m_time); time != ByRate) {
        request.timeColumn = time.toStdString();
    } else if (m_rate->value() > 0.0) {
        request.rate_Hz = m_rate->value();
    }
    return request;
}

void ImportForm::take(const devices::CsvQuestion::Answer& answer) {
    const devices::CsvImportRequest said = devices::answered({}, answer);
    if (said.hints.separator) {
        choose(*m_separator, QString::fromStdString(devices::separatorWord(*said.hints.separator)));
    }
    if (said.hints.decimal) {
        choose(*m_decimal, QString(QLatin1Char(*said.hints.decimal)));
    }
    if (said.hints.header) {
        choose(*m_header, QString::fromStdString(devices::headerWord(*said.hints.header)));
    }
    if (!said.timeColumn.empty()) {
        choose(*m_time, QString::fromStdString(said.timeColumn));
    }
    if (answer.isRate) {
        choose(*m_time, ByRate);
        onTime();
        m_rate->setFocus(Qt::OtherFocusReason);
    }
}

QString ImportForm::obstacle() const {
    return codeOf(*m_time) == ByRate && m_rate->value() <= 0.0
               ? tr("Enter the sampling rate in rows per second.")
               : QString();
}

} // namespace halbench::app
