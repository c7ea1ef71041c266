#pragma once

#include <QSplitter>

namespace halbench::widgets {
class EstimateTable;
}

namespace halbench::app {

/// A result: at the left what was found in words and numbers, scrolled, at the right its pictures. The table
/// of the words is as wide as its columns where that leaves room for the pictures; after that the user shares
/// it.
class WordsAndPictures : public QSplitter {
    Q_OBJECT

public:
    WordsAndPictures(QWidget* words, const widgets::EstimateTable* table, QWidget* pictures,
                     QWidget* parent = nullptr);

    void setWordsName(const QString& accessibleName);
    /// For a table of other columns.
    void shareAnew();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void share();

    const widgets::EstimateTable* m_table;
    bool m_isShared = false;
};

} // namespace halbench::app
