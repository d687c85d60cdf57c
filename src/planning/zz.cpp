namespace clearway { int placeholderA; }
