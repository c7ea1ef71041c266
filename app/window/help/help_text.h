#pragma once

#include <QTextBrowser>

namespace halbench::app {

/// Shows one page of resources/help with its pictures, which are no wider than the first width of its window.
class HelpText : public QTextBrowser {
    Q_OBJECT

public:
    explicit HelpText(QWidget* parent = nullptr);

    /// `folder`: what the addresses of the pictures begin at. `english`: the page in English, whose headings
    /// name the places of every language's page.
    void setPage(const QString& markdown, const QString& folder, const QString& english);
    void setMessage(const QString& text);

    /// Brings a heading to the top: one of the page itself, or of the English page. Nothing if there is none.
    void showSection(const QString& anchor);

    QVariant loadResource(int type, const QUrl& name) override;

private:
    void replaceDocument(QTextDocument* document);

    QString m_folder;
    QString m_english;
};

} // namespace halbench::app
