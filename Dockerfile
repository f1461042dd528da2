# The tools of pcl_indoor in a Debian image, from packages that are built and tried on the way:
#   docker build -t pcl_indoor .
#   docker run --rm -v "$PWD:/data" pcl_indoor pcl_indoor_pipeline /data/scan.pcd /data/result
FROM debian:12 AS build
COPY . /source
WORKDIR /source
RUN ./bootstrap package

FROM debian:12 AS try
RUN apt-get update && apt-get install -y --no-install-recommends cmake g++ make
COPY --from=build /source/build/package/*.deb /packages/
COPY README.md /source/
COPY docs/guide /source/docs/guide
COPY test/consumer /source/test/consumer
RUN apt-get install -y --no-install-recommends /packages/*.deb \
  && /source/test/consumer/try_packages.sh /packages installed && touch /tried

FROM debian:12-slim
COPY --from=try /tried /
COPY --from=build /source/build/package/libpcl-indoor[0-9]*.deb /source/build/package/pcl-indoor-tools_*.deb /packages/
RUN apt-get update && apt-get install -y --no-install-recommends /packages/*.deb openmpi-bin \
  && rm -rf /packages /tried /var/lib/apt/lists/*
WORKDIR /data
CMD ["pcl_indoor_pipeline", "-h"]
