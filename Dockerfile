# touchstone as an image, for computers that are not Debian 12. Build it in the top folder of the sources:
#
#     docker build -t touchstone .
#
# Then compile and run programs of the current folder:
#
#     docker run --rm -v "$PWD":/work touchstone nxcc -O2 -o sum sum.c
#     docker run --rm -v "$PWD":/work touchstone touchstone run -m ipsc860 -n 32 sum
#
# and in one go: docker run --rm -v "$PWD":/work touchstone sh -c 'nxcc -O2 -o sum sum.c && touchstone run -n 32 sum'.
# The files that a run writes belong to root; docker run --user "$(id -u):$(id -g)" makes them yours.
#
# The first stage builds Debian packages, the second installs them, with what they depend on and nothing else.
ARG DEBIAN=debian:12-slim

FROM $DEBIAN AS build
RUN apt-get -q update && DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends git make
COPY packages.txt /source/
COPY package/setup /source/package/
RUN cd /source && package/setup packages.txt run build cluster package && rm -rf /var/lib/apt/lists/*
COPY . /source
RUN cd /source && package/deb /packages

FROM $DEBIAN
COPY --from=build /packages/*.deb /packages/
RUN apt-get -q update && DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends \
        fonts-dejavu-core gnuplot-nox /packages/touchstone_*.deb /packages/touchstone-lab_*.deb /packages/libnx-mpi-dev_*.deb && \
    rm -rf /packages /var/lib/apt/lists/*
ENV LC_ALL=C.UTF-8
WORKDIR /work
CMD ["touchstone", "--help"]
