c     unknown.f - a call that is misspelt
      program unknow
      call gsync
      call gsnyc
      end
