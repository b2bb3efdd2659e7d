! fnx.h - the Paragon's name for fcube.h
      include 'fcube.h'
